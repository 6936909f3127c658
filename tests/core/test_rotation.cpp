/// The rotation of stress over a step: exact as a rotation, second order as an angle, one and the same in 2-D and 3-D.
#include "core/step/rotation.hpp"

#include <Eigen/Geometry>
#include <gtest/gtest.h>
#include <random>

namespace riedel::test {
namespace {

Mat<3> random_gradient(std::mt19937& random) {
  std::uniform_real_distribution<double> unit(-1.0, 1.0);
  Mat<3> L;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) L(i, j) = unit(random);
  return L;
}

/// The velocity gradient of a rotation with angular velocity w: v = w × x.
Mat<3> spin(const Vec<3>& w) {
  Mat<3> L;
  L << 0, -w[2], w[1], w[2], 0, -w[0], -w[1], w[0], 0;
  return L;
}

TEST(Rotation, IsOrthogonalForAnyVelocityGradientAndStep) {
  std::mt19937 random(1);
  for (const double dt : {1e-6, 0.1, 1.0, 30.0}) {
    const Mat<3> Q = rotation_of(random_gradient(random), dt);
    EXPECT_LT((Q * Q.transpose() - Mat<3>::Identity()).norm(), 1e-14);
    EXPECT_NEAR(Q.determinant(), 1.0, 1e-14);
  }
}

TEST(Rotation, DoesNotSeeTheSymmetricPart) {
  std::mt19937 random(2);
  const Mat<3> L = random_gradient(random), D = 0.5 * (L + L.transpose());
  EXPECT_LT((rotation_of(D, 0.3) - Mat<3>::Identity()).norm(), 1e-15);
  EXPECT_LT((rotation_of(L, 0.3) - rotation_of(L - D, 0.3)).norm(), 1e-15);
}

TEST(Rotation, TurnsAboutTheAxisOfTheSpinAndInItsSense) {
  const Vec<3> axis = Vec<3>(1, 2, -1).normalized();
  const double t = 0.4;
  const Mat<3> expected = Eigen::AngleAxisd(2.0 * std::atan(0.5 * t), axis).toRotationMatrix(); // Cayley's angle
  EXPECT_LT((rotation_of(spin(axis), t) - expected).norm(), 1e-14);
}

TEST(Rotation, IsTheSameInThePlaneForAPackAsInThreeDimensions) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> unit(-1.0, 1.0);
  const double dt = 0.7;
  std::array<std::array<double, pack_size>, 4> column; // σ11, σ22, √2 σ12, W12
  for (auto& numbers : column)
    for (double& x : numbers) x = unit(random);
  Sym<Pack> all = Sym<Pack>::zero();
  for (const std::size_t c : {0, 1}) all.m[c] = Pack::load(column[c].data());
  all.m[3] = Pack::load(column[2].data());
  rotate(all, cayley(Pack::load(column[3].data()), dt));

  std::array<double, pack_size> s_11, s_22, s_12;
  all.m[0].store(s_11.data());
  all.m[1].store(s_22.data());
  all.m[3].store(s_12.data());
  for (std::size_t k = 0; k < pack_size; ++k) {
    Mat<3> L = Mat<3>::Zero();
    L(0, 1) = column[3][k] + 0.2; // the symmetric part must not matter
    L(1, 0) = -column[3][k] + 0.2;
    const Sym<double> alone = rotated({{column[0][k], column[1][k], 0, column[2][k], 0, 0}}, rotation_of(L, dt));
    EXPECT_NEAR(s_11[k], alone.m[0], 1e-14);
    EXPECT_NEAR(s_22[k], alone.m[1], 1e-14);
    EXPECT_NEAR(s_12[k], alone.m[3], 1e-14);
  }
}

TEST(Rotation, IsTheSameInSpaceForAPackAsForEachPoint) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> unit(-1.0, 1.0);
  const double dt = 0.7;
  std::array<std::array<double, pack_size>, 9> column; // σ in Mandel components, W32, W13, W21
  for (auto& numbers : column)
    for (double& x : numbers) x = unit(random);
  Sym<Pack> all;
  for (std::size_t c = 0; c < 6; ++c) all.m[c] = Pack::load(column[c].data());
  rotate(all, cayley({Pack::load(column[6].data()), Pack::load(column[7].data()), Pack::load(column[8].data())}, dt));

  for (std::size_t k = 0; k < pack_size; ++k) {
    Sym<double> alone;
    for (std::size_t c = 0; c < 6; ++c) alone.m[c] = column[c][k];
    const Vec<3> w(column[6][k], column[7][k], column[8][k]);
    alone = rotated(alone, rotation_of(spin(w), dt));
    for (std::size_t c = 0; c < 6; ++c) {
      std::array<double, pack_size> lane;
      all.m[c].store(lane.data());
      EXPECT_NEAR(lane[k], alone.m[c], 1e-14);
    }
  }
}

/// Distance from the exactly rotated stress after a rotation by 1 rad in `steps` steps.
double error_after_one_radian(int steps) {
  const Vec<3> axis = Vec<3>(2, -1, 3).normalized();
  const Sym<double> start{{-1.0, -3.0, -2.0, 0.4, -0.7, 0.2}};
  const Mat<3> exact = Eigen::AngleAxisd(1.0, axis).toRotationMatrix();
  Sym<double> sigma = start;
  for (int i = 0; i < steps; ++i) sigma = rotated(sigma, rotation_of(spin(axis), 1.0 / steps));
  EXPECT_NEAR(norm(sigma), norm(start), 1e-12);
  return norm(sigma - rotated(start, exact));
}

TEST(Rotation, ConvergesToTheAccumulatedAngleWithSecondOrder) {
  const double coarse = error_after_one_radian(50), fine = error_after_one_radian(100);
  EXPECT_LT(coarse, 1e-3);
  EXPECT_NEAR(std::log2(coarse / fine), 2.0, 0.02);
}

} // namespace
} // namespace riedel::test
