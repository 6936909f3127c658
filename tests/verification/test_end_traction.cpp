/// A bar under a traction on its end, with the end anywhere in a cell: where domains fill the bar, the nodes of a
/// uniform stress are in equilibrium, also the last ones.
#include "core/step/loads.hpp"
#include "core/step/locate.hpp"
#include "support/schemes.hpp"

#include <cstdio>
#include <gtest/gtest.h>

namespace riedel::test {
namespace {

constexpr double h = 0.1, traction = 2e3;

/// A bar along x from `start` on, six cells long, under the uniform stress that balances the tractions on its ends, and
/// free at its sides. @return the largest nodal force over traction and cell
double imbalance(const std::string& scheme_name, double start) {
  State<2> state = elastic_state<2>({6, 3}, h, 2, 4, [](const Vec<2>&) { return true; });
  Points<2>& points = state.bodies[0].points;
  SurfaceTraction<2> load{.value = [](const Vec<2>&, const Vec<2>& n, double) -> Vec<2> { return traction * n; },
                          .initial_area = {}};
  load.initial_area.assign(static_cast<std::size_t>(points.size()), Vec<2>::Zero());
  for (Index p = 0; p < points.size(); ++p) {
    const double x = points.position[0][p];
    if (x < 0.5 * h) load.initial_area[static_cast<std::size_t>(p)][0] = -0.5 * h;
    if (x > 5.5 * h) load.initial_area[static_cast<std::size_t>(p)][0] = 0.5 * h;
    points.position[0][p] += start;
    points.position[1][p] += 0.3 * start;
    points.stress[0][p] = traction;
  }
  Model<2> model = model_with<2>(scheme_name);
  model.surface_tractions.push_back(std::move(load));
  Simulation<2> simulation(std::move(model), std::move(state));
  locate_points(simulation.state(), simulation.model());
  simulation.model().transfer->points_to_grid(simulation.state(), simulation.model());
  add_loads(simulation.state(), simulation.model());
  double maximum = 0.0;
  for (const NodeSums<2>& node : simulation.state().nodes.sums) maximum = std::max(maximum, node.force.norm());
  return maximum / (traction * h);
}

class EndTraction : public testing::TestWithParam<std::string> {};

TEST_P(EndTraction, BalancesAUniformStressWhereverInACellTheEndLies) {
  double worst = 0.0;
  for (const double start : {0.0, 0.013, 0.031, 0.05, 0.0777}) worst = std::max(worst, imbalance(GetParam(), start));
  std::printf("%-8s greatest nodal force %.1e of traction times cell\n", GetParam().c_str(), worst);
  if (traits(GetParam()).domain != PointDomain::none) {
    EXPECT_LT(worst, 1e-12);
  } else { // functions at points do not end where the material does
    EXPECT_LT(worst, 0.6);
    EXPECT_GT(worst, 1e-3) << "its domains fill the bar, and it does not say so";
  }
}

INSTANTIATE_TEST_SUITE_P(EveryScheme, EndTraction, testing::ValuesIn(scheme_names()),
                         [](const auto& tested) { return tested.param; });

/// The same by the virtual stress, which is exact for every scheme.
TEST_P(EndTraction, IsExactForEverySchemeAsAVirtualStress) {
  State<2> state = elastic_state<2>({6, 3}, h, 2, 4, [](const Vec<2>&) { return true; });
  Points<2>& points = state.bodies[0].points;
  for (Index p = 0; p < points.size(); ++p) {
    points.position[0][p] += 0.031;
    for (int c = 0; c < 3; ++c) points.stress[c][p] = -traction;
  }
  Model<2> model = model_with<2>(GetParam());
  model.confining_pressure = traction;
  Simulation<2> simulation(std::move(model), std::move(state));
  locate_points(simulation.state(), simulation.model());
  simulation.model().transfer->points_to_grid(simulation.state(), simulation.model());
  add_loads(simulation.state(), simulation.model());
  for (const NodeSums<2>& node : simulation.state().nodes.sums) EXPECT_LT(node.force.norm(), 1e-12 * traction * h);
}

} // namespace
} // namespace riedel::test
