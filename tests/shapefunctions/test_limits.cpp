/// Where one scheme must turn into another.
#include "support/problems.hpp"

#include <gtest/gtest.h>

namespace riedel::test {
namespace {

/// N_ip and ∇N_ip of the point at x by node, summed over entries: [node][0] = N, [node][1 + a] = ∂N/∂x_a.
template <int Dim>
std::vector<Eigen::Matrix<double, Dim + 1, 1>> weights(const std::string& name, const Vec<Dim>& x, double half_size,
                                                       const Mat<Dim>& F) {
  Counts<Dim> cells;
  cells.fill(4);
  const Grid<Dim> grid = grid_of<Dim>(cells, 1.0, 4);
  Points<Dim> points;
  points.resize(1, 0);
  for (int a = 0; a < Dim; ++a) {
    points.position[a][0] = x[a];
    points.half_size[a][0] = half_size;
    for (int b = 0; b < Dim; ++b) points.deformation_gradient[a * Dim + b][0] = F(a, b);
  }
  const auto shape = scheme<Dim>(name);
  Stencils<Dim> stencils;
  stencils.resize(1, shape->max_nodes());
  shape->evaluate(grid, points, {0, 1}, stencils);
  std::vector<Eigen::Matrix<double, Dim + 1, 1>> all(static_cast<std::size_t>(grid.node_count()));
  for (auto& w : all) w.setZero();
  const StencilGroup<Dim>& group = stencils.group_of(0);
  for (int e = 0; e < group.count; ++e) {
    auto& w = all[static_cast<std::size_t>(group.node_of(e, 0))];
    w[0] += group.value_of(e, 0);
    for (int a = 0; a < Dim; ++a) w[a + 1] += group.slope[(e * Dim + a) * pack_size];
  }
  return all;
}

template <int Dim>
double difference(const std::string& a, const std::string& b, const Vec<Dim>& x, double half_size,
                  const Mat<Dim>& F = Mat<Dim>::Identity()) {
  const auto A = weights<Dim>(a, x, half_size, F), B = weights<Dim>(b, x, half_size, F);
  double most = 0.0;
  for (std::size_t i = 0; i < A.size(); ++i) most = std::max(most, (A[i] - B[i]).cwiseAbs().maxCoeff());
  return most;
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
