/// Limits in which one scheme must become another.
#include "shapefunctions/one_stencil.hpp"

#include <gtest/gtest.h>

namespace riedel::test {
namespace {

template <int Dim>
double difference(const std::string& a, const std::string& b, const Vec<Dim>& x, double half_size,
                  const Mat<Dim>& F = Mat<Dim>::Identity()) {
  return test::difference<Dim>(weights<Dim>(a, x, half_size, F), weights<Dim>(b, x, half_size, F));
}

TEST(Gimp, TurnsIntoTheLinearSchemeAsTheDomainShrinks) {
  EXPECT_LT(difference<2>("gimp", "linear", {1.3, 2.6}, 1e-6), 1e-9);
  EXPECT_LT(difference<3>("gimp", "linear", {1.3, 2.6, 0.8}, 1e-6), 1e-9);
}

TEST(Cpdi, TurnsIntoTheLinearSchemeAsTheDomainShrinks) {
  EXPECT_LT(difference<2>("cpdi", "linear", {1.3, 2.6}, 1e-7), 1e-6);
  EXPECT_LT(difference<3>("cpdi", "linear", {1.3, 2.6, 0.8}, 1e-7), 1e-6);
}

TEST(Cpgimp, EqualsUniformGimpBeforeDeformation) {
  EXPECT_LT(difference<2>("cpgimp", "gimp", {1.3, 2.9}, 0.5), 1e-14);
  EXPECT_LT(difference<3>("cpgimp", "gimp", {1.3, 2.9, 0.2}, 0.25), 1e-14);
}

TEST(Cpgimp, IsNotChangedByARigidRotation) {
  Mat<2> F;
  F << 0.6, -0.8, 0.8, 0.6;
  EXPECT_LT(difference<2>("cpgimp", "gimp", {1.3, 2.9}, 0.5, F), 1e-14);
  Mat<3> G = Mat<3>::Identity();
  G.topLeftCorner<2, 2>() = F;
  EXPECT_LT(difference<3>("cpgimp", "gimp", {1.3, 2.9, 1.1}, 0.5, G), 1e-12);
}

TEST(Cpgimp, FollowsTheStretch) {
  const Mat<2> F = Vec<2>(1.5, 0.7).asDiagonal();
  EXPECT_GT(difference<2>("cpgimp", "gimp", {1.3, 2.9}, 0.4, F), 0.01);
  const auto w = weights<2>("cpgimp", {1.25, 2.0}, 0.5, F); // box from 0.5 to 2.0: reaches four nodes
  const Grid<2> grid = grid_of<2>({4, 4}, 1.0, 4);
  const double left = w[static_cast<std::size_t>(grid.node({4, 6}))][0]; // node at x = 0, y = 2
  const double alone = (0.5 * 0.5 / 2) / 1.5; // ∫ of the hat at 0 over [0.5, 1], over the width
  const double in_y = 1.0 - 0.35 / 2;         // mean of 1 − |s| over [−0.35, 0.35]
  EXPECT_NEAR(left, alone * in_y, 1e-14);
}

TEST(Gimp, MatchesThePapersValuesInEachOfItsCases) {
  // Bardenhagen & Kober (2004), eq. (44), h = 1, l = 0.25, one axis at a time (y on a node: 1 − l/(2h) = 0.875).
  const Grid<2> grid = grid_of<2>({4, 4}, 1.0, 4);
  const auto at = [&](double r) {
    return weights<2>("gimp", {2.0 + r, 2.0}, 0.25, Mat<2>::Identity())[static_cast<std::size_t>(grid.node({6, 6}))];
  };
  const double in_y = 0.875;
  EXPECT_NEAR(at(0.1)[0], (1 - (0.01 + 0.0625) / 0.5) * in_y, 1e-14);
  EXPECT_NEAR(at(0.1)[1], -0.1 / 0.25 * in_y, 1e-14);
  EXPECT_NEAR(at(-0.5)[0], 0.5 * in_y, 1e-14);
  EXPECT_NEAR(at(-0.5)[1], 1.0 * in_y, 1e-14);
  EXPECT_NEAR(at(1.1)[0], 0.15 * 0.15 / (4 * 0.25) * in_y, 1e-14);
  EXPECT_NEAR(at(1.1)[1], -0.15 / 0.5 * in_y, 1e-14);
  EXPECT_NEAR(at(1.3)[0], 0.0, 1e-14);
}

TEST(Cpdi, FollowsAShearedDomain) {
  // A domain of half vectors (0.5, 0) and (0.5, 0.5) around (2, 2): corners (1, 1.5), (2, 1.5), (2, 2.5), (3, 2.5).
  Mat<2> F;
  F << 1, 1, 0, 1;
  const auto w = weights<2>("cpdi", {2.0, 2.0}, 0.5, F);
  const Grid<2> grid = grid_of<2>({4, 4}, 1.0, 4);
  EXPECT_NEAR(w[static_cast<std::size_t>(grid.node({6, 6}))][0], 0.25 * (0.5 + 0.5), 1e-14);
  EXPECT_NEAR(w[static_cast<std::size_t>(grid.node({5, 5}))][0], 0.25 * 0.5, 1e-14);
  EXPECT_NEAR(w[static_cast<std::size_t>(grid.node({7, 7}))][0], 0.25 * 0.5, 1e-14);
}

} // namespace
} // namespace riedel::test
