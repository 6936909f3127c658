/// The traits of schemes: what they claim of their functions holds, and what they do not claim does not.
/// tests/shapefunctions/test_walls.cpp has ends at walls, tests/apps/test_verify.cpp orders, free faces and the error
/// of a translation, tests/apps/test_edge_balance.cpp pressure on points, and tests/verification/test_end_traction.cpp
/// domains that fill a body.
#include "core/step/grid_to_points.hpp"
#include "core/step/locate.hpp"
#include "shapefunctions/one_stencil.hpp"
#include "support/schemes.hpp"

#include <gtest/gtest.h>

namespace riedel::test {
namespace {

class EveryPromise : public testing::TestWithParam<std::string> {
protected:
  const SchemeTraits promised_ = traits(GetParam());
};

template <int Dim>
std::vector<Weight<Dim>> weights_of(const std::string& name, double half_size, const Vec<Dim>& stretch) {
  return weights<Dim>(name, Vec<3>(1.3, 2.6, 1.9).head<Dim>(), half_size, Mat<Dim>(stretch.asDiagonal()));
}

template <int Dim>
PointDomain domain_seen(const std::string& name) {
  const Vec<Dim> none = Vec<Dim>::Ones(), stretch = Vec<3>(1.2, 0.9, 1.1).head<Dim>();
  const std::vector<Weight<Dim>> usual = weights_of<Dim>(name, 0.4, none);
  if (difference<Dim>(weights_of<Dim>(name, 0.4, stretch), usual) > 1e-3) return PointDomain::stretched;
  return difference<Dim>(weights_of<Dim>(name, 0.3, none), usual) > 1e-3 ? PointDomain::fixed : PointDomain::none;
}

TEST_P(EveryPromise, OfADomainIsSeenInTheWeightsOfLargerAndOfStretchedPoints) {
  EXPECT_EQ(domain_seen<2>(GetParam()), promised_.domain);
  EXPECT_EQ(domain_seen<3>(GetParam()), scheme<3>(GetParam())->traits().domain);
}

/// N and ∇N, by node, of a light point among many that fill the four cells.
template <int Dim>
std::vector<Weight<Dim>> weights_in_a_body(const std::string& name, const Vec<Dim>& x) {
  Counts<Dim> cells;
  cells.fill(4);
  const Grid<Dim> grid = four_cells<Dim>();
  Points<Dim> points;
  fill<Dim>(points, cells, 1.0, 2, 1.0, 0, [](const Vec<Dim>&) { return true; });
  const Index p = points.size() - 1;
  for (int a = 0; a < Dim; ++a) points.position[a][p] = x[a];
  points.volume[0][p] = points.mass[0][p] = 1e-12;
  const auto shape = scheme<Dim>(name);
  Stencils<Dim> stencils;
  stencils.resize(points.size(), shape->max_nodes());
  Columns node_data{0};
  evaluate_anew(*shape, grid, points, node_data, stencils);
  std::vector<Weight<Dim>> all(static_cast<std::size_t>(grid.node_count()), Weight<Dim>::Zero());
  const StencilGroup<Dim>& group = stencils.group_of(p);
  for (int e = 0; e < group.count; ++e) {
    Weight<Dim>& w = all[static_cast<std::size_t>(group.node_of(e, p % pack_size))];
    w[0] += group.value_of(e, p % pack_size);
    for (int a = 0; a < Dim; ++a) w[a + 1] += group.gradient_of(e, a, p % pack_size);
  }
  return all;
}

/// Where a point, or a face or corner of its domain, passes a face of a cell or its middle.
template <int Dim>
double max_jump(const std::string& name) {
  constexpr double step = 1e-9;
  double maximum = 0.0;
  for (double place = 1.0; place <= 2.0; place += 0.125) {
    const Vec<Dim> x = Vec<3>(place, 1.7, 2.6).head<Dim>(), d = step * Vec<Dim>::Unit(0);
    maximum =
        std::max(maximum, difference<Dim>(weights_in_a_body<Dim>(name, x - d), weights_in_a_body<Dim>(name, x + d)));
  }
  return maximum;
}

template <int Dim>
void expect_jumps_as_promised(const std::string& name) {
  if (scheme<Dim>(name)->traits().continuous_gradients) {
    EXPECT_LT(max_jump<Dim>(name), 1e-6);
  } else {
    EXPECT_GT(max_jump<Dim>(name), 0.1) << "they are continuous, and it does not say so";
  }
}

TEST_P(EveryPromise, OfContinuousGradientsHoldsAcrossTheFacesOfCells) {
  expect_jumps_as_promised<2>(GetParam());
  expect_jumps_as_promised<3>(GetParam());
}

template <int Dim>
bool moves_its_points(const std::string& name) {
  Counts<Dim> cells;
  cells.fill(3);
  State<Dim> state = elastic_state<Dim>(cells, 0.5, 2, 5, [](const Vec<Dim>&) { return true; });
  const Model<Dim> model = model_with<Dim>(name);
  prepare_points(state, model);
  locate_points(state, model);
  for (NodeMotion<Dim>& motion : state.nodes.motion) motion.velocity.setConstant(1.0);
  update_kinematics(state, model, 0.1);
  const Points<Dim>& points = state.bodies[0].points;
  const Vec<Dim> before = points.position_of(0);
  move_scheme_columns(state, model, 0.1);
  return (points.position_of(0) - before).norm() > 0.05;
}

TEST_P(EveryPromise, ToMoveThePointsIsKeptAtTheEndOfAStep) {
  EXPECT_EQ(moves_its_points<2>(GetParam()), promised_.moves_points);
  EXPECT_EQ(moves_its_points<3>(GetParam()), scheme<3>(GetParam())->traits().moves_points);
}

/// Most of the following is measured only in two-dimensional problems.
TEST_P(EveryPromise, IsTheSameInTwoAndThreeDimensions) {
  const SchemeTraits in_space = scheme<3>(GetParam())->traits();
  EXPECT_EQ(in_space.order_across_cells, promised_.order_across_cells);
  EXPECT_EQ(in_space.converges_at_free_faces, promised_.converges_at_free_faces);
  EXPECT_EQ(in_space.balances_pressure_on_points, promised_.balances_pressure_on_points);
  EXPECT_EQ(in_space.ends_at_walls, promised_.ends_at_walls);
  EXPECT_EQ(in_space.translation_error, promised_.translation_error);
}

INSTANTIATE_TEST_SUITE_P(Registry, EveryPromise, testing::ValuesIn(scheme_names()),
                         [](const auto& tested) { return tested.param; });

} // namespace
} // namespace riedel::test
