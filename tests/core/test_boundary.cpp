/// Prescribed velocities: which nodes they constrain, the values, and the reaction force.
#include "core/step/boundary.hpp"
#include "support/problems.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace riedel::test {
namespace {

using testing::ElementsAre;
using testing::UnorderedElementsAre;

constexpr double dt = 0.01, end = 0.2;

double still(double) { return 0.0; }
double down(double) { return -2.0; }

/// A grid of 4 × 3 nodes, each with a mass, and a velocity reached from rest in one step.
struct HeldGrid {
  State<2> state;
  Model<2> model;

  explicit HeldGrid(std::vector<VelocityOnNodes<2>> conditions) {
    state.grid.nodes = {4, 3};
    state.nodes.resize(12);
    for (Index i = 0; i < 12; ++i) {
      state.nodes.sums[i].mass = 1.0 + i;
      state.nodes.motion[i].velocity = Vec<2>(0.1 * i, 1.0 - 0.3 * i);
      state.nodes.motion[i].acceleration = state.nodes.motion[i].velocity / dt;
    }
    state.time = end - dt;
    model.scheme = scheme<2>("linear");
    model.conditions = prescribe_each(std::move(conditions));
    bind_boundaries(state, model);
  }
  void apply() { apply_boundaries(state, model, dt); }
  [[nodiscard]] const BoundaryReport<2>& report(std::size_t c = 0) const { return model.conditions[c]->report(); }
};

/// For a condition on this grid.
std::vector<Index> nodes_of(const Grid<2>& grid, const VelocityOnNodes<2>& given) {
  const Boundary<2> condition = prescribe(given);
  condition->bind(grid, *scheme<2>("linear"));
  return condition->nodes();
}

TEST(RampedVelocity, RisesSmoothlyFromZeroToItsValue) {
  const auto v = ramped(-0.1, 4.0);
  EXPECT_EQ(v(-1.0), 0.0);
  EXPECT_EQ(v(0.0), 0.0);
  EXPECT_NEAR(v(1.0), -0.05 * (1.0 - std::sqrt(0.5)), 1e-15);
  EXPECT_NEAR(v(2.0), -0.05, 1e-15);
  EXPECT_EQ(v(4.0), -0.1);
  EXPECT_EQ(v(1e9), -0.1);
  EXPECT_NEAR(v(1e-4) / 1e-4, 0.0, 1e-4) << "no kink at the start";
  EXPECT_NEAR((v(4.0) - v(4.0 - 1e-4)) / 1e-4, 0.0, 1e-4) << "no kink at the end";
}

TEST(RampedVelocity, IsThereAtOnceWithoutARamp) { EXPECT_EQ(ramped(0.1, 0.0)(0.0), 0.1); }

TEST(Walls, BeginWhereAConditionHoldsEverythingUpToTheGridsEnd) {
  const auto walls = [](std::vector<VelocityOnNodes<2>> conditions) { return HeldGrid(conditions).state.grid.walls; };
  const auto along_y = [](Index first, Index last) {
    return VelocityOnNodes<2>{.name = "", .first = {0, first}, .last = {3, last}, .axis = 1, .velocity = still};
  };
  EXPECT_EQ(walls({})[1].first, Walls::none_below);
  EXPECT_EQ(walls({along_y(0, 1)})[1].first, 1);
  EXPECT_EQ(walls({along_y(0, 1)})[1].last, Walls::none_above);
  EXPECT_EQ(walls({along_y(0, 1)})[0].first, Walls::none_below);
  EXPECT_EQ(walls({along_y(0, 0), along_y(0, 1), along_y(2, 2)})[1].first, 1) << "the inner one";
  EXPECT_EQ(walls({along_y(2, 2)})[1].last, 2);
  EXPECT_EQ(walls({along_y(1, 1)})[1].first, Walls::none_below) << "a row in the middle of the grid";
  EXPECT_EQ(walls({along_y(0, 2)})[1].first, Walls::none_below) << "the whole grid held";
  VelocityOnNodes<2> sliding = along_y(0, 1);
  sliding.axis = 0;
  EXPECT_EQ(walls({sliding})[1].first, Walls::none_below) << "held along the row, not across";
  VelocityOnNodes<2> pin = along_y(0, 1);
  pin.first[0] = 1;
  EXPECT_EQ(walls({pin})[1].first, Walls::none_below) << "part of a row";
}

TEST(PrescribedVelocity, TakesTheNodesOfABoxBothCornersIncluded) {
  const HeldGrid held({});
  const auto nodes = [&](Counts<2> first, Counts<2> last) {
    return nodes_of(held.state.grid, {.name = "", .first = first, .last = last, .velocity = still});
  };
  EXPECT_THAT(nodes({1, 0}, {2, 1}), UnorderedElementsAre(1, 2, 5, 6));
  EXPECT_THAT(nodes({0, 2}, {3, 2}), UnorderedElementsAre(8, 9, 10, 11));
  EXPECT_THAT(nodes({2, 1}, {2, 1}), ElementsAre(6)) << "a single pinned node";

  Grid<3> grid;
  grid.nodes = {2, 3, 4};
  const Boundary<3> row = prescribe<3>({.name = "", .first = {1, 0, 2}, .last = {1, 2, 2}, .velocity = still});
  row->bind(grid, *scheme<3>("linear"));
  EXPECT_THAT(row->nodes(), UnorderedElementsAre(13, 15, 17));
}

TEST(PrescribedVelocity, LeavesOutABoxInside) {
  const HeldGrid held({});
  EXPECT_THAT(nodes_of(held.state.grid,
                       {.name = "", .last = {3, 2}, .velocity = still, .but_for = {{Counts<2>{0, 1}, {2, 1}}}}),
              UnorderedElementsAre(0, 1, 2, 3, 7, 8, 9, 10, 11));
}

TEST(CommonMotion, OfALinearMotionGetTheirShareBeyondItsRowsToo) {
  const HeldGrid given({});
  HeldGrid held({{.name = "x", .last = {3, 2}, .velocity = down, .linear = LinearMotion{0, 1, 3}}});
  held.apply();
  double force = 0.0;
  for (Index i = 0; i < 12; ++i) {
    const double share = (i % 4 - 1) / 2.0;
    EXPECT_EQ(held.state.nodes.motion[i].velocity[0], -2.0 * share) << i;
    EXPECT_EQ(held.state.nodes.motion[i].velocity[1], given.state.nodes.motion[i].velocity[1]) << i;
    force += share * (1.0 + i) * (-2.0 * share - given.state.nodes.motion[i].velocity[0]) / dt;
  }
  EXPECT_NEAR(held.report().reaction, force, 1e-12 * std::abs(force));
  EXPECT_NEAR(held.state.boundary_work, force * -2.0 * dt, 1e-12 * std::abs(force)) << "the force goes with the motion";
}

TEST(CommonMotion, WithoutAGivenVelocityKeepTheirMomentumAlongTheMotion) {
  const std::vector<VelocityOnNodes<2>> plate{
      {.name = "plate", .last = {3, 2}, .axis = 1, .linear = LinearMotion{1, 0, 2}}};
  const HeldGrid given({});
  HeldGrid held(plate);
  held.apply();
  double momentum = 0.0, mass = 0.0;
  for (Index i = 0; i < 12; ++i) {
    const double share = (i / 4) / 2.0;
    momentum += share * (1.0 + i) * given.state.nodes.motion[i].velocity[1];
    mass += share * share * (1.0 + i);
  }
  EXPECT_NEAR(held.report().speed, momentum / mass, 1e-14);
  EXPECT_NEAR(held.report().reaction, 0.0, 1e-11 * mass / dt);
  EXPECT_NEAR(held.state.boundary_work, 0.0, 1e-12);
  EXPECT_EQ(held.state.nodes.motion[11].velocity[1], held.report().speed);
  EXPECT_EQ(held.state.nodes.motion[6].velocity[1], 0.5 * held.report().speed);
  EXPECT_EQ(held.state.nodes.motion[2].velocity[1], 0.0);

  HeldGrid massless(plate);
  for (Index i = 0; i < 12; ++i) massless.state.nodes.sums[i].mass = 0.0;
  massless.apply();
  EXPECT_EQ(massless.report().speed, 0.0);
}

TEST(CommonMotion, GetTheirVelocityAlongOneAxisAndAnAccelerationThatLeadsToIt) {
  HeldGrid held({{.name = "top", .first = {0, 2}, .last = {3, 2}, .axis = 1, .velocity = down}});
  const AlignedVector<NodeMotion<2>> before = held.state.nodes.motion;
  held.apply();
  for (Index i = 0; i < 12; ++i) {
    const NodeMotion<2>& motion = held.state.nodes.motion[i];
    EXPECT_EQ(motion.velocity[0], before[i].velocity[0]);
    EXPECT_EQ(motion.acceleration[0], before[i].acceleration[0]);
    EXPECT_EQ(motion.velocity[1], i < 8 ? before[i].velocity[1] : -2.0);
    EXPECT_NEAR(dt * motion.acceleration[1], motion.velocity[1], 1e-14) << "the nodes started at rest";
  }
}

TEST(CommonMotion, TellTheChangeOfMomentumOverTheStepAsReactionAndItsWork) {
  HeldGrid held({{.name = "top", .first = {0, 2}, .last = {3, 2}, .axis = 1, .velocity = down}});
  double free = 0.0, mass = 0.0;
  for (Index i = 8; i < 12; ++i) {
    free += held.state.nodes.sums[i].mass * held.state.nodes.motion[i].velocity[1];
    mass += held.state.nodes.sums[i].mass;
  }
  held.apply();
  const double force = (mass * -2.0 - free) / dt;
  EXPECT_NEAR(held.report().reaction, force, 1e-12 * std::abs(force));
  EXPECT_NEAR(held.state.boundary_work, force * -2.0 * dt, 1e-12 * std::abs(force));
  held.apply();
  EXPECT_EQ(held.report().reaction, 0.0) << "of the present step alone";
}

TEST(CommonMotion, AskTheirVelocityForTheTimeGiven) {
  HeldGrid held({{.name = "top", .first = {0, 2}, .last = {3, 2}, .axis = 0, .velocity = [](double t) { return t; }}});
  held.apply();
  EXPECT_EQ(held.state.nodes.motion[9].velocity[0], end);
  apply_boundary_velocities(held.state, held.model, 3.0);
  EXPECT_EQ(held.state.nodes.motion[9].velocity[0], 3.0);
}

TEST(CommonMotion, OfTwoConditionsAreHeldAlongBothAxesWithAReactionEach) {
  const VelocityOnNodes<2> bottom{.name = "bottom", .first = {0, 0}, .last = {3, 0}, .axis = 1, .velocity = still},
      pin{.name = "pin", .first = {1, 0}, .last = {1, 0}, .axis = 0, .velocity = still};
  HeldGrid both({bottom, pin}), alone({bottom});
  const double pinned = -both.state.nodes.sums[1].mass * both.state.nodes.motion[1].velocity[0] / dt;
  both.apply();
  alone.apply();
  EXPECT_EQ(both.state.nodes.motion[1].velocity, Vec<2>(0, 0));
  EXPECT_NEAR(both.state.nodes.motion[2].velocity[0], 0.2, 1e-15) << "only one node is pinned";
  EXPECT_NEAR(both.report(1).reaction, pinned, 1e-12 * std::abs(pinned));
  EXPECT_EQ(both.report().reaction, alone.report().reaction);
}

TEST(CommonMotion, OfTwoConditionsThatOverlapAreCountedOnce) {
  const VelocityOnNodes<2> left{.name = "left", .first = {0, 2}, .last = {2, 2}, .axis = 1, .velocity = down},
      right{.name = "right", .first = {1, 2}, .last = {3, 2}, .axis = 1, .velocity = down},
      whole{.name = "whole", .first = {0, 2}, .last = {3, 2}, .axis = 1, .velocity = down};
  HeldGrid two({left, right}), one({whole});
  two.apply();
  one.apply();
  const double sum = two.report().reaction + two.report(1).reaction;
  EXPECT_NEAR(sum, one.report().reaction, 1e-12 * std::abs(sum));
}

TEST(CommonMotion, KeepTheirAccelerationWhenVelocitiesAloneAreSet) {
  HeldGrid held({{.name = "top", .first = {0, 2}, .last = {3, 2}, .axis = 1, .velocity = down}});
  const Vec<2> before = held.state.nodes.motion[9].acceleration;
  apply_boundary_velocities(held.state, held.model, end);
  EXPECT_EQ(held.state.nodes.motion[9].velocity[1], -2.0);
  EXPECT_EQ(held.state.nodes.motion[9].acceleration, before);
  EXPECT_EQ(held.report().reaction, 0.0);
}

TEST(PrescribedVelocity, FollowsATableThatIsLinearBetweenItsTimes) {
  const VelocityCourse v = tabled({1.0, 2.0, 4.0}, {0.0, -1.0, 3.0});
  EXPECT_EQ(v(0.0), 0.0);
  EXPECT_DOUBLE_EQ(v(1.25), -0.25);
  EXPECT_EQ(v(2.0), -1.0);
  EXPECT_DOUBLE_EQ(v(3.0), 1.0);
  EXPECT_EQ(v(9.0), 3.0);
  EXPECT_THROW((void)tabled({1.0, 1.0}, {0.0, 0.0}), InputError);
  EXPECT_THROW((void)tabled({1.0}, {0.0, 0.0}), InputError);
  EXPECT_THROW((void)tabled({}, {}), InputError);
}

TEST(MovingGrid, ThatFollowsAConditionThatIsNotThereIsRefused) {
  Model<2> model = model_with<2>("linear");
  model.moving_grids.push_back({.axis = 1, .moving_row = 4, .platen = "lid"});
  const auto make = [&] {
    Simulation<2>(std::move(model), elastic_state<2>({2, 2}, 1.0, 2, 2, [](auto&) { return true; }));
  };
  EXPECT_THAT(make, testing::ThrowsMessage<InputError>(testing::HasSubstr("'lid'")));
}

} // namespace
} // namespace riedel::test
