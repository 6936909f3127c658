/// B-splines: their values, and how often they can be differentiated.
#include "shapefunctions/one_stencil.hpp"

#include <gtest/gtest.h>

namespace riedel::test {
namespace {

/// N of the node at (2 m, 2 m) and its gradient along x, for a point r to the right of it.
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

/// Jumps of a derivative across the knots, from one-sided difference quotients of the gradient.
double curvature_jump(const std::string& name, double knot) {
  const double d = 1e-4;
  const auto gradient = [&](double r) { return in_a_row(name, r)[1]; };
  const double after = (gradient(knot + 2 * d) - gradient(knot + d)) / d;
  const double before = (gradient(knot - d) - gradient(knot - 2 * d)) / d;
  return std::abs(after - before);
}

TEST(Bspline3, HasACurvatureWithoutJumpsAndBspline2HasJumpsInTheMiddleOfCells) {
  for (const double knot : {0.0, 1.0}) EXPECT_LT(curvature_jump("bspline3", knot), 1e-3);
  for (const double knot : {0.5, 1.5}) EXPECT_GT(curvature_jump("bspline2", knot), 0.5);
}

} // namespace
} // namespace riedel::test
