/// Tractions carried by points on a surface: it follows the deformed surface, whatever the order of the points.
#include "core/step/loads.hpp"
#include "core/step/locate.hpp"
#include "core/step/usf.hpp"
#include "core/step/usl.hpp"
#include "support/problems.hpp"

#include <Eigen/Geometry>
#include <gtest/gtest.h>

namespace riedel::test {
namespace {

constexpr double pressure = 3e4;

/// A block of points of which those on the side of largest x carry pressure; points are numbered from the top, so that
/// sorting changes their order.
template <int Dim>
struct PressedBlock {
  State<Dim> state;
  Model<Dim> model = model_with<Dim>("gimp");
  Vec<Dim> area = Vec<Dim>::Zero(); ///< of the whole side at the start

  PressedBlock() {
    Counts<Dim> cells;
    cells.fill(3);
    state = elastic_state<Dim>(cells, 0.5, 2, 3, [](const Vec<Dim>&) { return true; });
    Points<Dim>& points = state.bodies[0].points;
    for (Index p = 0; p < points.size() / 2; ++p)
      for (int a = 0; a < Dim; ++a) std::swap(points.position[a][p], points.position[a][points.size() - 1 - p]);
    SurfaceTraction<Dim> load{.value = uniform_pressure<Dim>(pressure), .initial_area = {}};
    load.initial_area.assign(static_cast<std::size_t>(points.size()), Vec<Dim>::Zero());
    for (Index p = 0; p < points.size(); ++p)
      if (points.position[0][p] > 1.3) load.initial_area[static_cast<std::size_t>(p)][0] = std::pow(0.25, Dim - 1);
    for (const Vec<Dim>& share : load.initial_area) area += share;
    model.surface_tractions.push_back(std::move(load));
    prepare_points(state, model);
    locate_points(state, model);
  }
  void deform(const Mat<Dim>& F) {
    Points<Dim>& points = state.bodies[0].points;
    for (Index p = 0; p < points.size(); ++p)
      for (int c = 0; c < Dim * Dim; ++c) points.deformation_gradient[c][p] = F(c / Dim, c % Dim);
  }
  Vec<Dim> total_force() {
    state.nodes.clear_sums();
    add_surface_tractions(state, model);
    Vec<Dim> sum = Vec<Dim>::Zero();
    for (const NodeSums<Dim>& node : state.nodes.sums) sum += node.force;
    return sum;
  }
};

TEST(SurfaceTraction, PushesAgainstTheOutwardSide) {
  PressedBlock<2> block;
  ASSERT_NEAR(block.area[0], 1.5, 1e-14);
  EXPECT_LT((block.total_force() - Vec<2>(-pressure * 1.5, 0.0)).norm(), 1e-9 * pressure);
}

TEST(SurfaceTraction, StandsOnARotatedAndStretchedEdgeWithTheEdgesNewLength) {
  PressedBlock<2> block;
  const Mat<2> R = Eigen::Rotation2Dd(0.6).toRotationMatrix();
  block.deform(
      R * Vec<2>(0.7, 1.4).asDiagonal()); // the edge, along y, grows by 1.4; the material behind it does not matter
  const Vec<2> expected = -pressure * 1.5 * 1.4 * (R * Vec<2>(1.0, 0.0));
  EXPECT_LT((block.total_force() - expected).norm(), 1e-9 * pressure);
}

TEST(SurfaceTraction, StandsOnTheParallelogramThatAShearedSideBecomes) {
  PressedBlock<3> block;
  Mat<3> F;
  F << 1.1, 0.3, -0.2, 0.1, 0.8, 0.25, -0.3, 0.15, 1.3;
  block.deform(F);
  const Vec<3> expected = -pressure * 1.5 * 1.5 * F.col(1).cross(F.col(2)); // edges along y and z
  EXPECT_LT((block.total_force() - expected).norm(), 1e-9 * pressure);
}

TEST(SurfaceTraction, ActsWhereItsPointsAre) {
  PressedBlock<2> block;
  block.total_force();
  for (Index i = 0; i < block.state.nodes.size(); ++i) {
    const bool near = block.state.grid.position(block.state.grid.index(i))[0] > 0.9; // the points lie at x = 1.375
    EXPECT_TRUE(near || block.state.nodes.sums[i].force.isZero(0.0)) << "node " << i;
  }
}

TEST(SurfaceTraction, AddsToTheForcesThatStandThere) {
  PressedBlock<2> block;
  const Vec<2> once = block.total_force();
  add_surface_tractions(block.state, block.model);
  Vec<2> twice = Vec<2>::Zero();
  for (const NodeSums<2>& node : block.state.nodes.sums) twice += node.force;
  EXPECT_LT((twice - 2.0 * once).norm(), 1e-9 * pressure);
}

/// A side that crosses cell lines anywhere: hats are integrated exactly along it.
TEST(SurfaceTraction, IsSpreadAsTheHatsLieAlongTheSide) {
  PressedBlock<2> block;
  Points<2>& points = block.state.bodies[0].points;
  for (Index p = 0; p < points.size(); ++p) points.position[1][p] += 0.17; // faces of 0.25 in cells of 0.5
  block.model.surface_tractions.front().value = [](const Vec<2>&, const Vec<2>&, double) { return Vec<2>(2.0, -3.0); };
  block.total_force();
  const Grid<2>& grid = block.state.grid;
  for (Index i = 0; i < block.state.nodes.size(); ++i) {
    const Vec<2> x = grid.position(grid.index(i));
    if (std::abs(x[0] - 1.5) > 1e-9) continue; // the side lies on this column of nodes
    const auto integral = [&](double y) {      // of the node's hat, up to y
      const double s = std::clamp((y - x[1]) / 0.5, -1.0, 1.0);
      return 0.5 * (s < 0.0 ? 0.5 * (1.0 + s) * (1.0 + s) : 1.0 - 0.5 * (1.0 - s) * (1.0 - s));
    };
    const double share = integral(0.17 + 1.5) - integral(0.17);
    EXPECT_NEAR(block.state.nodes.sums[i].force[0], 2.0 * share, 1e-12) << x.transpose();
    EXPECT_NEAR(block.state.nodes.sums[i].force[1], -3.0 * share, 1e-12) << x.transpose();
  }
}

TEST(SurfaceTraction, MayDependOnPlaceNormalAndTime) {
  PressedBlock<2> block;
  block.state.time = 3.0;
  block.model.surface_tractions.front().value = [](const Vec<2>& x, const Vec<2>& normal, double time) -> Vec<2> {
    return time * (x[1] - 0.5) * normal;
  };
  EXPECT_NEAR(block.total_force()[0], 3.0 * 1.5 * (0.75 - 0.5), 1e-12) << "linear along the side: exact";
}

TEST(SurfaceTraction, DoesTheWorkOfItsForceOnTheMovingSide) {
  PressedBlock<2> block;
  Points<2>& points = block.state.bodies[0].points;
  for (Index p = 0; p < points.size(); ++p) {
    const bool carries = points.position[0][p] > 1.3;
    points.velocity[0][p] = carries ? -0.5 : 100.0; // others must not count
    points.velocity[1][p] = 7.0;                    // along the side
  }
  EXPECT_NEAR(surface_work(block.state, block.model, 0.1), 0.1 * 0.5 * pressure * 1.5, 1e-9 * pressure);
}

/// A block that falls by a metre, across cells, with points re-sorted during the fall.
Simulation<2> fallen_block(StepFunction<2> step, const std::string& chosen, bool by_points) {
  Model<2> model = model_with<2>("gimp");
  model.step = step;
  model.transfer = transfer<2>(chosen);
  model.cfl = 0.1;
  const Vec<2> g(3.0, -1e4);
  if (by_points)
    model.body_forces.push_back({.per_mass = [g](const Points<2>&, Index, double) { return g; }});
  else
    model.gravity = g;
  Simulation<2> simulation(std::move(model), elastic_state<2>({3, 3}, 0.5, 2, 6, [](const Vec<2>&) { return true; }));
  while (simulation.state().time < 0.014) simulation.step();
  return simulation;
}

TEST(BodyForce, ThatIsTheSameEverywhereMovesPointsAndWorksAsGravity) {
  for (const StepFunction<2> step : {musl_step<2>, usl_step<2>, usf_step<2>})
    for (const std::string& chosen : transfer_names()) {
      const Simulation<2> by_points = fallen_block(step, chosen, true), by_nodes = fallen_block(step, chosen, false);
      const Points<2>&a = by_points.state().bodies[0].points, &b = by_nodes.state().bodies[0].points;
      ASSERT_LT(b.position_of(0)[1], -0.5) << "the block crosses no cell";
      for (Index p = 0; p < a.size(); ++p) {
        EXPECT_LT((a.position_of(p) - b.position_of(p)).norm(), 1e-12);
        EXPECT_LT((a.velocity_of(p) - b.velocity_of(p)).norm(), 1e-10 * b.velocity_of(p).norm());
      }
      const double work = by_nodes.energies().external;
      EXPECT_NEAR(by_points.energies().external, work, 0.05 * work); // by velocities at the steps' ends
    }
}

TEST(BodyForce, ActsOnEachPointByItsPlaceAndTime) {
  PressedBlock<2> block;
  block.model.surface_tractions.clear();
  block.state.time = 2.0;
  block.model.body_forces.push_back({.per_mass = [](const Points<2>& points, Index p, double time) -> Vec<2> {
    return time * points.position_of(p);
  }});
  const Points<2>& points = block.state.bodies[0].points;
  Vec<2> expected = Vec<2>::Zero(), sum = expected;
  for (Index p = 0; p < points.size(); ++p) expected += 2.0 * points.mass[0][p] * points.position_of(p);
  block.model.transfer->points_to_grid(block.state, block.model);
  add_loads(block.state, block.model);
  for (const NodeSums<2>& node : block.state.nodes.sums) sum += node.force;
  EXPECT_LT((sum - expected).norm(), 1e-12 * expected.norm());
}

} // namespace
} // namespace riedel::test
