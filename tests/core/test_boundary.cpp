/// Prescribed velocities: which nodes they hold, what they set, and the force that it takes.
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

  explicit HeldGrid(const std::vector<NodeCondition<2>>& conditions) {
    state.grid.nodes = {4, 3};
    state.nodes.resize(12);
    for (Index i = 0; i < 12; ++i) {
      state.nodes.sums[i].mass = 1.0 + i;
      state.nodes.motion[i].velocity = Vec<2>(0.1 * i, 1.0 - 0.3 * i);
      state.nodes.motion[i].acceleration = state.nodes.motion[i].velocity / dt;
    }
    bind_conditions(state, conditions);
  }
};

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
  const auto walls = [](std::vector<NodeCondition<2>> conditions) { return HeldGrid(conditions).state.grid.walls; };
  const auto along_y = [](Index first, Index last) {
    return NodeCondition<2>{.name = "", .first = {0, first}, .last = {3, last}, .axis = 1, .velocity = still};
  };
  EXPECT_EQ(walls({})[1].first, Walls::none_below);
  EXPECT_EQ(walls({along_y(0, 1)})[1].first, 1);
  EXPECT_EQ(walls({along_y(0, 1)})[1].last, Walls::none_above);
  EXPECT_EQ(walls({along_y(0, 1)})[0].first, Walls::none_below);
  EXPECT_EQ(walls({along_y(0, 0), along_y(0, 1), along_y(2, 2)})[1].first, 1) << "the inner one";
  EXPECT_EQ(walls({along_y(2, 2)})[1].last, 2);
  EXPECT_EQ(walls({along_y(1, 1)})[1].first, Walls::none_below) << "a row in the middle of the grid";
  EXPECT_EQ(walls({along_y(0, 2)})[1].first, Walls::none_below) << "the whole grid held";
  NodeCondition<2> sliding = along_y(0, 1);
  sliding.axis = 0;
  EXPECT_EQ(walls({sliding})[1].first, Walls::none_below) << "held along the row, not across";
  NodeCondition<2> pin = along_y(0, 1);
  pin.first[0] = 1;
  EXPECT_EQ(walls({pin})[1].first, Walls::none_below) << "part of a row";
}

TEST(NodeCondition, TakesTheNodesOfABoxBothCornersIncluded) {
  const HeldGrid held({});
  const auto nodes = [&](Counts<2> first, Counts<2> last) {
    return nodes_of<2>(held.state.grid, {.name = "", .first = first, .last = last, .velocity = still});
  };
  EXPECT_THAT(nodes({1, 0}, {2, 1}), UnorderedElementsAre(1, 2, 5, 6));
  EXPECT_THAT(nodes({0, 2}, {3, 2}), UnorderedElementsAre(8, 9, 10, 11));
  EXPECT_THAT(nodes({2, 1}, {2, 1}), ElementsAre(6)) << "a single pinned node";

  Grid<3> grid;
  grid.nodes = {2, 3, 4};
  EXPECT_THAT(nodes_of<3>(grid, {.name = "", .first = {1, 0, 2}, .last = {1, 2, 2}, .velocity = still}),
              UnorderedElementsAre(13, 15, 17));
}

TEST(NodeCondition, LeavesOutABoxInside) {
  const HeldGrid held({});
  EXPECT_THAT(nodes_of<2>(held.state.grid,
                          {.name = "", .last = {3, 2}, .velocity = still, .but_for = {{Counts<2>{0, 1}, {2, 1}}}}),
              UnorderedElementsAre(0, 1, 2, 3, 7, 8, 9, 10, 11));
}

TEST(HeldNodes, OfALinearMotionGetTheirShareBeyondItsRowsToo) {
  const HeldGrid given({});
  HeldGrid held({{.name = "x", .last = {3, 2}, .velocity = down, .linear = LinearMotion{0, 1, 3}}});
  hold_nodes(held.state, end, dt);
  double force = 0.0;
  for (Index i = 0; i < 12; ++i) {
    const double share = (i % 4 - 1) / 2.0;
    EXPECT_EQ(held.state.nodes.motion[i].velocity[0], -2.0 * share) << i;
    EXPECT_EQ(held.state.nodes.motion[i].velocity[1], given.state.nodes.motion[i].velocity[1]) << i;
    force += share * (1.0 + i) * (-2.0 * share - given.state.nodes.motion[i].velocity[0]) / dt;
  }
  EXPECT_NEAR(held.state.held[0].reaction, force, 1e-12 * std::abs(force));
  EXPECT_NEAR(held.state.boundary_work, force * -2.0 * dt, 1e-12 * std::abs(force)) << "the force goes with the motion";
}

TEST(HeldNodes, WithoutAGivenVelocityKeepTheirMomentumAlongTheMotion) {
  const std::vector<NodeCondition<2>> plate{
      {.name = "plate", .last = {3, 2}, .axis = 1, .linear = LinearMotion{1, 0, 2}}};
  const HeldGrid given({});
  HeldGrid held(plate);
  hold_nodes(held.state, end, dt);
  double momentum = 0.0, mass = 0.0;
  for (Index i = 0; i < 12; ++i) {
    const double share = (i / 4) / 2.0;
    momentum += share * (1.0 + i) * given.state.nodes.motion[i].velocity[1];
    mass += share * share * (1.0 + i);
  }
  EXPECT_NEAR(held.state.held[0].speed, momentum / mass, 1e-14);
  EXPECT_NEAR(held.state.held[0].reaction, 0.0, 1e-11 * mass / dt);
  EXPECT_NEAR(held.state.boundary_work, 0.0, 1e-12);
  EXPECT_EQ(held.state.nodes.motion[11].velocity[1], held.state.held[0].speed);
  EXPECT_EQ(held.state.nodes.motion[6].velocity[1], 0.5 * held.state.held[0].speed);
  EXPECT_EQ(held.state.nodes.motion[2].velocity[1], 0.0);

  HeldGrid massless(plate);
  for (Index i = 0; i < 12; ++i) massless.state.nodes.sums[i].mass = 0.0;
  hold_nodes(massless.state, end, dt);
  EXPECT_EQ(massless.state.held[0].speed, 0.0);
}

TEST(HeldNodes, GetTheirVelocityAlongOneAxisAndAnAccelerationThatLeadsToIt) {
  HeldGrid held({{.name = "top", .first = {0, 2}, .last = {3, 2}, .axis = 1, .velocity = down}});
  const AlignedVector<NodeMotion<2>> before = held.state.nodes.motion;
  hold_nodes(held.state, end, dt);
  for (Index i = 0; i < 12; ++i) {
    const NodeMotion<2>& motion = held.state.nodes.motion[i];
    EXPECT_EQ(motion.velocity[0], before[i].velocity[0]);
    EXPECT_EQ(motion.acceleration[0], before[i].acceleration[0]);
    EXPECT_EQ(motion.velocity[1], i < 8 ? before[i].velocity[1] : -2.0);
    EXPECT_NEAR(dt * motion.acceleration[1], motion.velocity[1], 1e-14) << "the nodes started at rest";
  }
}

TEST(HeldNodes, TellTheChangeOfMomentumOverTheStepAsReactionAndItsWork) {
  HeldGrid held({{.name = "top", .first = {0, 2}, .last = {3, 2}, .axis = 1, .velocity = down}});
  double free = 0.0, mass = 0.0;
  for (Index i = 8; i < 12; ++i) {
    free += held.state.nodes.sums[i].mass * held.state.nodes.motion[i].velocity[1];
    mass += held.state.nodes.sums[i].mass;
  }
  hold_nodes(held.state, end, dt);
  const double force = (mass * -2.0 - free) / dt;
  EXPECT_NEAR(held.state.held[0].reaction, force, 1e-12 * std::abs(force));
  EXPECT_NEAR(held.state.boundary_work, force * -2.0 * dt, 1e-12 * std::abs(force));
  hold_nodes(held.state, end, dt);
  EXPECT_EQ(held.state.held[0].reaction, 0.0) << "of the present step alone";
}

TEST(HeldNodes, AskTheirVelocityForTheTimeGiven) {
  HeldGrid held({{.name = "top", .first = {0, 2}, .last = {3, 2}, .axis = 0, .velocity = [](double t) { return t; }}});
  hold_nodes(held.state, end, dt);
  EXPECT_EQ(held.state.nodes.motion[9].velocity[0], end);
  hold_velocities(held.state, 3.0);
  EXPECT_EQ(held.state.nodes.motion[9].velocity[0], 3.0);
}

TEST(HeldNodes, OfTwoConditionsAreHeldAlongBothAxesWithAReactionEach) {
  const NodeCondition<2> bottom{.name = "bottom", .first = {0, 0}, .last = {3, 0}, .axis = 1, .velocity = still},
      pin{.name = "pin", .first = {1, 0}, .last = {1, 0}, .axis = 0, .velocity = still};
  HeldGrid both({bottom, pin}), alone({bottom});
  const double pinned = -both.state.nodes.sums[1].mass * both.state.nodes.motion[1].velocity[0] / dt;
  hold_nodes(both.state, end, dt);
  hold_nodes(alone.state, end, dt);
  EXPECT_EQ(both.state.nodes.motion[1].velocity, Vec<2>(0, 0));
  EXPECT_NEAR(both.state.nodes.motion[2].velocity[0], 0.2, 1e-15) << "only one node is pinned";
  EXPECT_NEAR(both.state.held[1].reaction, pinned, 1e-12 * std::abs(pinned));
  EXPECT_EQ(both.state.held[0].reaction, alone.state.held[0].reaction);
}

TEST(HeldNodes, OfTwoConditionsThatOverlapAreCountedOnce) {
  const NodeCondition<2> left{.name = "left", .first = {0, 2}, .last = {2, 2}, .axis = 1, .velocity = down},
      right{.name = "right", .first = {1, 2}, .last = {3, 2}, .axis = 1, .velocity = down},
      whole{.name = "whole", .first = {0, 2}, .last = {3, 2}, .axis = 1, .velocity = down};
  HeldGrid two({left, right}), one({whole});
  hold_nodes(two.state, end, dt);
  hold_nodes(one.state, end, dt);
  const double sum = two.state.held[0].reaction + two.state.held[1].reaction;
  EXPECT_NEAR(sum, one.state.held[0].reaction, 1e-12 * std::abs(sum));
}

TEST(HeldNodes, KeepTheirAccelerationWhenVelocitiesAloneAreSet) {
  HeldGrid held({{.name = "top", .first = {0, 2}, .last = {3, 2}, .axis = 1, .velocity = down}});
  const Vec<2> before = held.state.nodes.motion[9].acceleration;
  hold_velocities(held.state, end);
  EXPECT_EQ(held.state.nodes.motion[9].velocity[1], -2.0);
  EXPECT_EQ(held.state.nodes.motion[9].acceleration, before);
  EXPECT_EQ(held.state.held[0].reaction, 0.0);
}

/// Two rigid points above a grid of 4 × 4 cells.
struct RigidPair {
  State<2> state;
  std::shared_ptr<const ShapeFunction<2>> shape = scheme<2>("linear");

  RigidPair() {
    state.grid = grid_of<2>({4, 4}, 1.0, 0);
    state.nodes.resize(state.grid.node_count());
    RigidBody<2> platen{.name = "platen", .axis = 1, .velocity = down};
    platen.points.resize(2, 0);
    for (const Index p : {0, 1}) {
      platen.points.position[0][p] = 1.5 + p;
      platen.points.position[1][p] = 3.25;
    }
    state.rigid_bodies.push_back(std::move(platen));
    state.rigid_bodies[0].stencils.resize(2, shape->max_nodes());
    bind_conditions<2>(state, {{.name = "bottom", .last = {4, 0}, .axis = 1, .velocity = still}});
  }
};

TEST(RigidBody, HoldsEachNodeThatItsPointsTouchOnce) {
  RigidPair pair;
  find_rigid_nodes(pair.state, *pair.shape);
  ASSERT_EQ(pair.state.held.size(), 2U);
  EXPECT_EQ(pair.state.held[1].name, "platen");
  EXPECT_THAT(pair.state.held[1].nodes, UnorderedElementsAre(16, 17, 18, 21, 22, 23));
  EXPECT_EQ(pair.state.held[0].nodes.size(), 5U) << "the condition keeps its own";
}

TEST(RigidBody, TakesOtherNodesWhenItMovesIntoAnotherCell) {
  RigidPair pair;
  move_rigid_points(pair.state, end, 0.25); // by −0.5
  EXPECT_EQ(pair.state.rigid_bodies[0].points.position[1][0], 2.75);
  EXPECT_EQ(pair.state.rigid_bodies[0].points.position[0][0], 1.5);
  find_rigid_nodes(pair.state, *pair.shape);
  EXPECT_THAT(pair.state.held[1].nodes, UnorderedElementsAre(11, 12, 13, 16, 17, 18));
}

TEST(RigidBody, IsNamedWhenItLeavesTheGrid) {
  RigidPair pair;
  move_rigid_points(pair.state, end, 5.0);
  EXPECT_THAT([&] { find_rigid_nodes(pair.state, *pair.shape); },
              testing::ThrowsMessage<RunError>(testing::HasSubstr("'platen'")));
}

} // namespace
} // namespace riedel::test
