/// Functions that end at a wall: what the wall does to them.
#include "shapefunctions/one_stencil.hpp"
#include "support/schemes.hpp"

#include <gtest/gtest.h>

namespace riedel::test {
namespace {

/// Walls along x at 1 m and 3 m.
Grid<2> between_walls() {
  Grid<2> grid = four_cells<2>();
  grid.walls[0] = {.first = 5, .last = 7};
  return grid;
}

/// N, and gradient along x, by node along x, summed over y.
std::array<Vec<2>, 13> along_x(const std::string& name, double x, const Grid<2>& grid) {
  const std::vector<Weight<2>> all = weights<2>(name, {x, 2.2}, 0.5, Mat<2>::Identity(), grid);
  std::array<Vec<2>, 13> sums;
  sums.fill(Vec<2>::Zero());
  for (Index i = 0; i < grid.node_count(); ++i)
    sums[static_cast<std::size_t>(grid.index(i)[0])] += all[static_cast<std::size_t>(i)].head<2>();
  return sums;
}

class EverySchemeThatEndsAtWalls : public testing::TestWithParam<std::string> {};

TEST_P(EverySchemeThatEndsAtWalls, LetsTheLastRowAloneTellTheMotionAtAWall) {
  EXPECT_NEAR(along_x(GetParam(), 1.0, between_walls())[5][0], 1.0, 1e-10);
  EXPECT_NEAR(along_x(GetParam(), 3.0, between_walls())[7][0], 1.0, 1e-10);
  EXPECT_LT(along_x(GetParam(), 1.0, four_cells<2>())[5][0], 0.8) << "without the wall its neighbours have a say";
}

TEST_P(EverySchemeThatEndsAtWalls, GivesNothingToNodesBehindAWallAndNoNegativeWeight) {
  for (double x = 1.0; x <= 3.0; x += 0.0625) {
    const auto N = along_x(GetParam(), x, between_walls());
    for (std::size_t i = 0; i < N.size(); ++i) {
      EXPECT_GE(N[i][0], -1e-12) << x;
      if (i < 5 || i > 7) { EXPECT_EQ(N[i].norm(), 0.0) << x; }
    }
  }
}

/// Continuity where the modified functions meet the others.
TEST_P(EverySchemeThatEndsAtWalls, HasContinuousGradientsUpToTheWall) {
  const double step = 1e-6;
  for (double x = 1.0 + step; x < 3.0; x += 0.0625) {
    const auto before = along_x(GetParam(), x - step / 2, between_walls());
    const auto after = along_x(GetParam(), x + step / 2, between_walls());
    for (std::size_t i = 0; i < before.size(); ++i) EXPECT_LT((after[i] - before[i]).norm(), 10 * step) << x;
  }
}

TEST_P(EverySchemeThatEndsAtWalls, MarksAPointBehindAWallAsLost) {
  EXPECT_GT(along_x(GetParam(), 1.0 - 1e-8, between_walls())[5][0], 0.99) << "round-off is no offence";
  for (const double x : {0.9, 3.1})
    for (const Vec<2>& N : along_x(GetParam(), x, between_walls())) EXPECT_EQ(N.norm(), 0.0);
}

/// The gradient of the motion between a wall and the first free row is that of the rows.
TEST_P(EverySchemeThatEndsAtWalls, StretchesTheLastCellAsItsTwoRowsSay) {
  const auto N = along_x(GetParam(), 1.0, between_walls());
  EXPECT_NEAR(N[5][1], -1.0, 1e-10);
  EXPECT_NEAR(N[6][1], 1.0, 1e-10);
}

INSTANTIATE_TEST_SUITE_P(Names, EverySchemeThatEndsAtWalls,
                         testing::ValuesIn(schemes_that([](const SchemeTraits& of) { return of.ends_at_walls; })),
                         [](const auto& tested) { return tested.param; });

TEST(EverySchemeThatDoesNotEndAtWalls, HasTheSameFunctionsThere) {
  for (const std::string& name : schemes_that([](const SchemeTraits& of) { return !of.ends_at_walls; }))
    for (const double x : {1.0, 1.1, 1.4}) {
      const auto with = along_x(name, x, between_walls()), without = along_x(name, x, four_cells<2>());
      for (std::size_t i = 0; i < with.size(); ++i) EXPECT_EQ((with[i] - without[i]).norm(), 0.0) << name << ", " << x;
    }
}

} // namespace
} // namespace riedel::test
