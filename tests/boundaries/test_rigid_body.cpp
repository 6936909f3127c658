/// Rigid points: which nodes they constrain, and their motion.
#include "core/step/boundaries/rigid_body.hpp"

#include "core/step/boundary.hpp"
#include "support/problems.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace riedel::test {
namespace {

using testing::UnorderedElementsAre;

constexpr double end = 0.2;

double still(double) { return 0.0; }
double down(double) { return -2.0; }

/// Two rigid points above a grid of 4 × 4 cells, and a floor.
struct RigidPair {
  State<2> state;
  Model<2> model;

  RigidPair() {
    state.grid = grid_of<2>({4, 4}, 1.0, 0);
    state.nodes.resize(state.grid.node_count());
    RigidPoints<2> platen{.name = "platen", .direction = {.axis = 1}, .velocity = down};
    platen.points.resize(2, 0);
    for (const Index p : {0, 1}) {
      platen.points.position[0][p] = 1.5 + p;
      platen.points.position[1][p] = 3.25;
    }
    model.scheme = scheme<2>("linear");
    model.conditions = prescribe_each<2>({{.name = "bottom", .last = {4, 0}, .axis = 1, .velocity = still}});
    model.conditions.push_back(std::make_unique<RigidBody<2>>(std::move(platen)));
    bind_boundaries(state, model);
  }
  [[nodiscard]] const RigidBody<2>& platen() const { return dynamic_cast<RigidBody<2>&>(*model.conditions[1]); }
};

TEST(RigidBody, HoldsEachNodeThatItsPointsTouchOnce) {
  RigidPair pair;
  follow_boundaries(pair.state, pair.model);
  EXPECT_THAT(pair.platen().nodes(), UnorderedElementsAre(16, 17, 18, 21, 22, 23));
  EXPECT_EQ(pair.model.conditions[0]->nodes().size(), 5U) << "the other condition keeps its own";
}

TEST(RigidBody, TakesOtherNodesWhenItMovesIntoAnotherCell) {
  RigidPair pair;
  move_boundaries(pair.model, end, 0.25); // by −0.5
  EXPECT_EQ(pair.platen().points()->position[1][0], 2.75);
  EXPECT_EQ(pair.platen().points()->position[0][0], 1.5);
  follow_boundaries(pair.state, pair.model);
  EXPECT_THAT(pair.platen().nodes(), UnorderedElementsAre(11, 12, 13, 16, 17, 18));
}

TEST(RigidBody, IsNamedWhenItLeavesTheGrid) {
  RigidPair pair;
  move_boundaries(pair.model, end, 5.0);
  EXPECT_THAT([&] { follow_boundaries(pair.state, pair.model); },
              testing::ThrowsMessage<RunError>(testing::HasSubstr("'platen'")));
}

TEST(RigidBody, FromABoxOfNodesHasAPointInEachOfItsCells) {
  const Grid<2> grid = grid_of<2>({4, 4}, 0.5, 0);
  const auto& entry = catalogue().in_2d.boundaries.find("rigid_body");
  const NodeBox<2> place{.first = {1, 2}, .last = {3, 3}, .axis = 1};
  const Boundary<2> body = entry.make("block", place, Values(entry.description.parameters));
  body->bind(grid, *scheme<2>("linear"));
  body->follow(grid, *scheme<2>("linear"));
  EXPECT_THAT(body->nodes(), UnorderedElementsAre(11, 12, 13, 16, 17, 18));
  const Boundary<2> nothing =
      entry.make("block", {.first = {1, 2}, .last = {3, 2}}, Values(entry.description.parameters));
  EXPECT_THROW(nothing->bind(grid, *scheme<2>("linear")), InputError);
}

} // namespace
} // namespace riedel::test
