/// B-splines: their values, how often they can be differentiated, and what a wall does to them.
#include "shapefunctions/one_stencil.hpp"

#include <gtest/gtest.h>

namespace riedel::test {
namespace {

/// N of the node at (2 m, 2 m) and its slope along x, for a point r to the right of it.
Weight<2> in_a_row(const std::string& name, double r) {
  return weights<2>(name, {2.0 + r, 2.0}, 0.5)[static_cast<std::size_t>(four_cells<2>().node({6, 6}))];
}

TEST(Bspline2, EqualsGimpWithADomainAsWideAsACell) {
  for (const double x : {1.0, 1.3, 1.5, 1.77})
    EXPECT_LT(difference<3>(weights<3>("bspline2", {x, 2.9, 0.2}, 0.1), weights<3>("gimp", {x, 2.9, 0.2}, 0.5)), 1e-14);
}

TEST(Bspline2, HasTheKnownValues) {
  const double in_y = 0.75; // of the node that the point's y is on
  EXPECT_NEAR(in_a_row("bspline2", 0.0)[0], 0.75 * in_y, 1e-15);
  EXPECT_NEAR(in_a_row("bspline2", 1.0)[0], 0.125 * in_y, 1e-15);
  EXPECT_NEAR(in_a_row("bspline2", -0.5)[0], 0.5 * in_y, 1e-15);
  EXPECT_NEAR(in_a_row("bspline2", -0.5)[1], 1.0 * in_y, 1e-15);
  EXPECT_NEAR(in_a_row("bspline2", 1.4)[0], 0.005 * in_y, 1e-15);
}

TEST(Bspline3, HasTheKnownValues) {
  const double in_y = 2.0 / 3.0;
  EXPECT_NEAR(in_a_row("bspline3", 0.0)[0], in_y * in_y, 1e-15);
  EXPECT_NEAR(in_a_row("bspline3", -1.0)[0], in_y / 6.0, 1e-15);
  EXPECT_NEAR(in_a_row("bspline3", -1.0)[1], in_y / 2.0, 1e-15);
  EXPECT_NEAR(in_a_row("bspline3", 0.5)[0], in_y * 23.0 / 48.0, 1e-15);
  EXPECT_NEAR(in_a_row("bspline3", 1.5)[0], in_y / 48.0, 1e-15);
}

/// Jumps of a derivative across the knots, from one-sided difference quotients of the slope.
double curvature_jump(const std::string& name, double knot) {
  const double d = 1e-4;
  const auto slope = [&](double r) { return in_a_row(name, r)[1]; };
  const double after = (slope(knot + 2 * d) - slope(knot + d)) / d;
  const double before = (slope(knot - d) - slope(knot - 2 * d)) / d;
  return std::abs(after - before);
}

TEST(Bspline3, HasACurvatureWithoutJumpsAndBspline2HasJumpsInTheMiddleOfCells) {
  for (const double knot : {0.0, 1.0}) EXPECT_LT(curvature_jump("bspline3", knot), 1e-3);
  for (const double knot : {0.5, 1.5}) EXPECT_GT(curvature_jump("bspline2", knot), 0.5);
}

/// Walls along x at 1 m and 3 m.
Grid<2> between_walls() {
  Grid<2> grid = four_cells<2>();
  grid.walls[0] = {.first = 5, .last = 7};
  return grid;
}

/// N, and slope along x, by node along x, summed over y.
std::array<Vec<2>, 13> along_x(const std::string& name, double x, const Grid<2>& grid) {
  const std::vector<Weight<2>> all = weights<2>(name, {x, 2.2}, 0.5, Mat<2>::Identity(), grid);
  std::array<Vec<2>, 13> sums;
  sums.fill(Vec<2>::Zero());
  for (Index i = 0; i < grid.node_count(); ++i)
    sums[static_cast<std::size_t>(grid.index(i)[0])] += all[static_cast<std::size_t>(i)].head<2>();
  return sums;
}

class EveryBspline : public testing::TestWithParam<std::string> {};

TEST_P(EveryBspline, LetsTheLastRowAloneTellTheMotionAtAWall) {
  EXPECT_NEAR(along_x(GetParam(), 1.0, between_walls())[5][0], 1.0, 1e-10);
  EXPECT_NEAR(along_x(GetParam(), 3.0, between_walls())[7][0], 1.0, 1e-10);
  EXPECT_LT(along_x(GetParam(), 1.0, four_cells<2>())[5][0], 0.8) << "without the wall its neighbours have a say";
}

TEST_P(EveryBspline, GivesNothingToNodesBehindAWallAndNoNegativeWeight) {
  for (double x = 1.0; x <= 3.0; x += 0.0625) {
    const auto N = along_x(GetParam(), x, between_walls());
    for (std::size_t i = 0; i < N.size(); ++i) {
      EXPECT_GE(N[i][0], -1e-12) << x;
      if (i < 5 || i > 7) { EXPECT_EQ(N[i].norm(), 0.0) << x; }
    }
  }
}

/// Continuity where the modified functions meet the others.
TEST_P(EveryBspline, HasContinuousSlopesUpToTheWall) {
  const double step = 1e-6;
  for (double x = 1.0 + step; x < 3.0; x += 0.0625) {
    const auto before = along_x(GetParam(), x - step / 2, between_walls());
    const auto after = along_x(GetParam(), x + step / 2, between_walls());
    for (std::size_t i = 0; i < before.size(); ++i) EXPECT_LT((after[i] - before[i]).norm(), 10 * step) << x;
  }
}

TEST_P(EveryBspline, MarksAPointBehindAWallAsLost) {
  EXPECT_GT(along_x(GetParam(), 1.0 - 1e-8, between_walls())[5][0], 0.99) << "round-off is no offence";
  for (const double x : {0.9, 3.1})
    for (const Vec<2>& N : along_x(GetParam(), x, between_walls())) EXPECT_EQ(N.norm(), 0.0);
}

/// The slope of the motion between a wall and the first free row is that of the rows.
TEST_P(EveryBspline, StretchesTheLastCellAsItsTwoRowsSay) {
  const auto N = along_x(GetParam(), 1.0, between_walls());
  EXPECT_NEAR(N[5][1], -1.0, 1e-10);
  EXPECT_NEAR(N[6][1], 1.0, 1e-10);
}

INSTANTIATE_TEST_SUITE_P(Orders, EveryBspline, testing::Values("bspline2", "bspline3"),
                         [](const auto& tested) { return tested.param; });

} // namespace
} // namespace riedel::test
