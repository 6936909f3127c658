/// Mandel's algebra against the same operations on 3 × 3 matrices, and the Lode angle at the states that define it.
#include "core/base/tensor.hpp"

#include <Eigen/LU>
#include <gtest/gtest.h>
#include <random>

namespace riedel::test {
namespace {

/// Full matrices, no two components alike.
class Tensors : public testing::Test {
protected:
  Mat<3> symmetric() {
    Mat<3> a;
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j) a(i, j) = unit_(random_);
    return 0.5 * (a + a.transpose());
  }
  Sym<Pack> packed(std::array<Sym<double>, pack_size>& lanes) {
    Sym<Pack> all;
    for (Sym<double>& lane : lanes) lane = to_sym(symmetric());
    for (std::size_t c = 0; c < 6; ++c) {
      std::array<double, pack_size> column;
      for (std::size_t k = 0; k < pack_size; ++k) column[k] = lanes[k].m[c];
      all.m[c] = Pack::load(column.data());
    }
    return all;
  }

private:
  std::mt19937 random_{5};
  std::uniform_real_distribution<double> unit_{-1.0, 1.0};
};

std::array<double, pack_size> numbers(const Pack& pack) {
  std::array<double, pack_size> lanes;
  pack.store(lanes.data());
  return lanes;
}

TEST_F(Tensors, ComeBackFromMandelComponentsUnchanged) {
  for (int trial = 0; trial < 20; ++trial) {
    const Mat<3> a = symmetric();
    EXPECT_LT((to_matrix(to_sym(a)) - a).norm(), 1e-15);
  }
}

TEST_F(Tensors, TakeTheSymmetricPartOfAnyMatrix) {
  Mat<3> a;
  a << 1, 2, 3, 4, 5, 6, 7, 8, 10;
  EXPECT_LT((to_matrix(to_sym(a)) - 0.5 * (a + a.transpose())).norm(), 1e-14);
}

TEST_F(Tensors, HaveTheirDoubleContractionAsDotProduct) {
  for (int trial = 0; trial < 20; ++trial) {
    const Mat<3> a = symmetric(), b = symmetric();
    EXPECT_NEAR(dot(to_sym(a), to_sym(b)), a.cwiseProduct(b).sum(), 1e-14);
    EXPECT_NEAR(norm(to_sym(a)), a.norm(), 1e-14);
  }
}

TEST_F(Tensors, AddScaleAndLoseTheirMeanAsMatricesDo) {
  const Mat<3> a = symmetric(), b = symmetric();
  const Sym<double> s = to_sym(a), t = to_sym(b);
  EXPECT_LT((to_matrix(s + t) - (a + b)).norm(), 1e-15);
  EXPECT_LT((to_matrix(s - t) - (a - b)).norm(), 1e-15);
  EXPECT_LT((to_matrix(3.0 * s) - 3.0 * a).norm(), 1e-14);
  EXPECT_LT((to_matrix(s / 4.0) - a / 4.0).norm(), 1e-15);
  EXPECT_NEAR(trace(s), a.trace(), 1e-15);
  EXPECT_LT((to_matrix(deviator(s)) - (a - a.trace() / 3.0 * Mat<3>::Identity())).norm(), 1e-15);
  EXPECT_LT((to_matrix(Sym<double>::identity()) - Mat<3>::Identity()).norm(), 1e-15);
  EXPECT_EQ(norm(Sym<double>::zero()), 0.0);
}

TEST_F(Tensors, HaveTheDeterminantOfTheirMatrix) {
  for (int trial = 0; trial < 20; ++trial) {
    const Mat<3> a = symmetric();
    EXPECT_NEAR(determinant(to_sym(a)), a.determinant(), 1e-14);
  }
}

TEST_F(Tensors, GiveAPackWhatTheyGiveItsNumbers) {
  std::array<Sym<double>, pack_size> a, b;
  const Sym<Pack> A = packed(a), B = packed(b);
  const auto dots = numbers(dot(A, B)), norms = numbers(norm(A)), traces = numbers(trace(A)),
             determinants = numbers(determinant(A)), angles = numbers(cos_3_lode(deviator(A)));
  for (std::size_t k = 0; k < pack_size; ++k) {
    EXPECT_NEAR(dots[k], dot(a[k], b[k]), 1e-15);
    EXPECT_NEAR(norms[k], norm(a[k]), 1e-15);
    EXPECT_NEAR(traces[k], trace(a[k]), 1e-15);
    EXPECT_NEAR(determinants[k], determinant(a[k]), 1e-15);
    EXPECT_NEAR(angles[k], cos_3_lode(deviator(a[k])), 1e-13);
  }
}

/// Stress over its trace, so that compression is positive: the major principal value is in the compressed direction.
double lode(double major, double middle, double minor) {
  return cos_3_lode(deviator(Sym<double>{{major, middle, minor, 0.0, 0.0, 0.0}}));
}

TEST(LodeAngle, TellsTriaxialCompressionExtensionAndPureShearApart) {
  EXPECT_NEAR(lode(0.6, 0.2, 0.2), -1.0, 1e-14) << "triaxial compression";
  EXPECT_NEAR(lode(0.4, 0.4, 0.2), 1.0, 1e-14) << "triaxial extension";
  EXPECT_NEAR(lode(0.5, 0.3, 0.1), 0.0, 1e-14) << "middle value half way, as at the critical state in plane strain";
}

/// With a = (cos t, cos(t − 2π/3), cos(t + 2π/3)), tr a² = 3/2 and tr a³ = 3/4 cos 3t, so that cos 3θ = −cos 3t.
TEST_F(Tensors, HaveALodeAngleThatTurnsWithTheirPrincipalValuesAndNotWithTheFrame) {
  Mat<3> Q;
  Q << 2, -2, 1, 1, 2, 2, 2, 1, -2;
  Q /= 3.0;
  for (double t = 0.02; t < 3.0; t += 0.1) {
    const double third = 2.0 * std::numbers::pi / 3.0;
    const Vec<3> principal(std::cos(t), std::cos(t - third), std::cos(t + third));
    const Mat<3> turned = Q * principal.asDiagonal() * Q.transpose();
    EXPECT_NEAR(cos_3_lode(to_sym(1e-3 * turned)), -std::cos(3.0 * t), 1e-12) << "t = " << t;
  }
}

TEST(LodeAngle, StaysWithinItsBoundsAndIsDefinedWhereTheDeviatorVanishes) {
  EXPECT_EQ(cos_3_lode(Sym<double>::zero()), -1.0);
  for (int k = 1; k < 200; ++k) {
    const double size = 1e-3 * k;
    const double cosine = cos_3_lode(Sym<double>{{2 * size, -size, -size, 0.0, 0.0, 0.0}});
    EXPECT_GE(cosine, -1.0);
    EXPECT_NEAR(cosine, -1.0, 1e-14);
  }
}

} // namespace
} // namespace riedel::test
