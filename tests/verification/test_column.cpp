/// An elastic column under its own weight, relaxed to rest between rollers: σ_yy = −ρ g (H − Y), with Y the initial
/// height, holds at any strain because the width is constant. The order of convergence is tested for each scheme.
///
/// At small strain the stress is the same in all points of a cell. With two points per cell they miss the linear course
/// by ± ρ g h/4, which is an error of √3/4 h/H and order one; one point in the middle is exact. Yet with one point per
/// cell nodes may bear forces that cancel at every point, so that rest is not unique: the further the points have
/// moved, the more the stress at rest depends on the path. Hence no order is required with one point at large strain.
#include "core/analysis/error_norm.hpp"
#include "core/run/relax.hpp"
#include "support/schemes.hpp"

#include <cstdio>
#include <gtest/gtest.h>
#include <omp.h>

namespace riedel::test {
namespace {

constexpr double height = 1.0, density = 1000.0, gravity = 10.0;

/// @param strain ρ g H/E, the strain at the foot
Simulation<2> column(const std::string& scheme_name, Index cells, Index per_cell, double strain) {
  constexpr Index margin = 4;
  State<2> state = elastic_state<2>(
      {2, cells}, height / cells, per_cell, margin, [](const Vec<2>&) { return true; },
      {{"youngs_modulus", density * gravity * height / strain}, {"poissons_ratio", 0.0}, {"density", density}});
  Model<2> model = model_with<2>(scheme_name);
  model.gravity = {0.0, -gravity};
  model.transfer = transfer<2>("flip", {{"flip", 0.0}});
  const auto still = [](double) { return 0.0; };
  const Counts<2> last{state.grid.nodes[0] - 1, state.grid.nodes[1] - 1};
  model.conditions = prescribe_each<2>({{"left", {0, 0}, {margin, last[1]}, 0, still},
                                        {"right", {margin + 2, 0}, last, 0, still},
                                        {"bottom", {0, 0}, {last[0], margin}, 1, still}});
  return {std::move(model), std::move(state)};
}

/// L2 norm of the error of σ_yy over that of σ_yy.
double error(const std::string& scheme_name, Index cells, Index per_cell, double strain) {
  Simulation<2> simulation = column(scheme_name, cells, per_cell, strain);
  const Points<2>& points = simulation.state().bodies[0].points;
  std::vector<double> exact(static_cast<std::size_t>(points.size())); // by id
  for (Index p = 0; p < points.size(); ++p)
    exact[static_cast<std::size_t>(points.id[static_cast<std::size_t>(p)])] =
        -density * gravity * (height - points.position[1][p]);
  // Wide functions come to rest slowly; the remaining motion changes the stress by less than 3e-4, the root of its
  // share.
  const bool slow = reaches_without_domain(traits(scheme_name));
  const double moving = relax(simulation, (slow ? 200 : 100) * cells, Run<2>(simulation));
  EXPECT_LT(moving, slow ? 5e-8 : 1e-8) << "the column is not at rest";
  ErrorNorm norm;
  for (Index p = 0; p < points.size(); ++p) {
    const double sigma = exact[static_cast<std::size_t>(points.id[static_cast<std::size_t>(p)])];
    norm.add(points.initial_volume[0][p], square(points.stress[1][p] - sigma), square(sigma));
  }
  return norm.value();
}

/// Errors for 8, 16 and 32 cells.
struct Convergence {
  std::array<double, 3> errors;
  [[nodiscard]] double order() const { return 0.5 * std::log2(errors[0] / errors[2]); }
};

Convergence refine(const std::string& scheme_name, Index per_cell, double strain) {
  Convergence c{};
  for (std::size_t i = 0; i < 3; ++i) c.errors[i] = error(scheme_name, 8 << i, per_cell, strain);
  std::printf("%-7s strain %.3f, %d point(s) per cell and direction: %.2e %.2e %.2e, orders %.2f %.2f\n",
              scheme_name.c_str(), strain, per_cell, c.errors[0], c.errors[1], c.errors[2],
              std::log2(c.errors[0] / c.errors[1]), std::log2(c.errors[1] / c.errors[2]));
  return c;
}

/// Whether gradients in the middle of a cell are those of hats: ± 1/(2h) on the cell's four nodes.
bool slopes_as_hats_in_the_middle(const std::string& name) {
  const Simulation<2> one = column(name, 5, 1, 1e-3);
  const auto shape = scheme<2>(name);
  Points<2> points = one.state().bodies[0].points;
  Stencils<2> stencils;
  stencils.resize(points.size(), shape->max_nodes());
  Columns node_data{0};
  evaluate_anew(*shape, one.state().grid, points, node_data, stencils);
  const Index p = 4; // of two in a row, in the third row of five
  double absolute = 0.0;
  const StencilGroup<2>& group = stencils.group_of(p);
  for (int e = 0; e < group.count; ++e) absolute += std::abs(group.gradient_of(e, 1, p % pack_size));
  return std::abs(absolute * one.state().grid.cell[1] - 2.0) < 1e-9;
}

class ColumnTest : public testing::TestWithParam<std::string> {
protected:
  void SetUp() override { omp_set_num_threads(1); } // too small to share
  const SchemeTraits promised_ = traits(GetParam());
};

TEST_P(ColumnTest, CarriesItsWeightWithFirstOrderAtSmallStrain) {
  const Convergence two = refine(GetParam(), 2, 1e-3);
  EXPECT_GT(two.order(), 0.98);
  EXPECT_LT(two.errors[0], 1.02 * std::sqrt(3.0) / 32.0);
  const Convergence one = refine(GetParam(), 1, 1e-3);
  // Gradients that extend beyond a cell involve nodes at the free end which the material hardly fills. Those of
  // quadratic splines in the middle of a cell do not.
  if (reaches_without_domain(promised_) && !slopes_as_hats_in_the_middle(GetParam())) {
    EXPECT_GT(one.order(), 1.1);
    EXPECT_LT(one.errors[0], 0.02);
    return;
  }
  for (const double error : one.errors) EXPECT_LT(error, 1e-3) << "as small as the strain";
}

/// The upper points settle by 0.08, 0.16 and 0.32 cells.
TEST_P(ColumnTest, ConvergesWhilePointsMoveWithinTheirCells) {
  const Convergence one = refine(GetParam(), 1, 0.02), two = refine(GetParam(), 2, 0.02);
  if (!promised_.continuous_gradients) { // nor do weights follow new lengths: an error that no refinement removes
    for (const double error : one.errors) EXPECT_NEAR(error, 0.78 * 0.02, 0.02 * 0.02);
    EXPECT_GT(two.errors[2], two.errors[1]);
    return;
  }
  if (reaches_without_domain(promised_)) { // they do not follow lengths either, but smooth the error
    EXPECT_LT(one.errors[0], 0.025);
    EXPECT_GT(one.order(), 0.35);
    EXPECT_GT(two.order(), 1.1);
    EXPECT_LT(two.errors[2], 5e-3);
    return;
  }
  EXPECT_LT(one.errors[0], 5e-3);
  EXPECT_LT(one.errors[2], 1.2e-3);
  EXPECT_GT(two.order(), 1.1);
  EXPECT_TRUE(one.order() > 0.9 || one.errors[0] < 0.02 * 0.02) << "or as small as the strain's square";
}

/// The upper points settle by 0.4, 0.8 and 1.6 cells.
TEST_P(ColumnTest, ConvergesWhilePointsCrossCellsIfItsDomainsFollowTheStretch) {
  const Convergence two = refine(GetParam(), 2, 0.1);
  if (!promised_.continuous_gradients) {
    EXPECT_GT(two.errors[2], 0.1) << "the error of crossing cells";
  } else if (promised_.domain == PointDomain::fixed) { // domains overlap, by the strain
    EXPECT_GT(two.order(), 0.7);
    EXPECT_LT(two.errors[2], 0.02);
  } else if (reaches_without_domain(promised_)) { // a tenth of the hats' error remains, that of sums over points
    EXPECT_LT(two.errors[2], 0.015);
  } else {
    EXPECT_GT(two.order(), 1.1);
    EXPECT_LT(two.errors[2], 0.01);
  }
}

INSTANTIATE_TEST_SUITE_P(EveryScheme, ColumnTest, testing::ValuesIn(scheme_names()),
                         [](const auto& tested) { return tested.param; });

} // namespace
} // namespace riedel::test
