/// Principal values and directions, equal values and packs included.
#include "core/base/spectral.hpp"

#include <Eigen/Geometry>
#include <gtest/gtest.h>
#include <random>

namespace riedel::test {
namespace {

/// Σ a_i v_i ⊗ v_i along random directions.
Sym<double> tensor_with(const Vec<3>& values, std::mt19937& random) {
  std::normal_distribution<double> unit;
  Mat<3> a;
  for (int i = 0; i < 9; ++i) a(i / 3, i % 3) = unit(random);
  Vec<3> u = a.col(0).normalized(), v = (a.col(1) - u.dot(a.col(1)) * u).normalized();
  Mat<3> Q;
  Q << u, v, u.cross(v);
  return from_spectral(values, Q);
}

TEST(Spectral, FindsPrincipalValuesAndDirectionsToRoundOff) {
  std::mt19937 random(3);
  for (const Vec<3>& values : {Vec<3>(3, 2, -5), Vec<3>(1, 1, -2), Vec<3>(4, -1, -1), Vec<3>(2, 2, 2),
                               Vec<3>(1, 1 - 1e-9, 1 - 2e-9), Vec<3>(1e9, 1e-3, 0), Vec<3>(0, 0, 0)})
    for (int trial = 0; trial < 200; ++trial) {
      const Sym<double> a = tensor_with(values, random);
      const Spectral found = spectral(a);
      const double scale = values.norm();
      EXPECT_LE((found.values - values).norm(), 1e-14 * scale);
      EXPECT_LE((found.directions.transpose() * found.directions - Mat<3>::Identity()).norm(), 4e-15);
      EXPECT_LE(norm(from_spectral(found.values, found.directions) - a), 1e-14 * scale);
    }
}

TEST(Spectral, EndsForATensorThatIsNotFinite) {
  Sym<double> a = Sym<double>::identity();
  a.m[4] = std::numeric_limits<double>::quiet_NaN();
  EXPECT_FALSE(std::isfinite(spectral(a).values.sum()));
}

TEST(Spectral, MapsPrincipalValues) {
  std::mt19937 random(5);
  const Sym<double> a = tensor_with({0.3, -0.1, 0.05}, random);
  const Sym<double> e = isotropic_function(spectral(a), [](double x) { return std::exp(x); });
  EXPECT_NEAR(determinant(e), std::exp(0.25), 1e-14);
  EXPECT_LT(norm(isotropic_function(spectral(e), [](double x) { return std::log(x); }) - a), 1e-14);
  EXPECT_LT(norm(congruent(e, Sym<double>::identity()) -
                 isotropic_function(spectral(a), [](double x) { return std::exp(2 * x); })),
            1e-14);
}

TEST(PrincipalValues, AgreeForPacksAndPoints) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> unit(-1.0, 1.0);
  for (int trial = 0; trial < 100; ++trial) {
    std::array<Sym<double>, pack_size> points;
    Sym<Pack> packed;
    for (auto& point : points) {
      const double a = unit(random);
      point = trial % 3 ? tensor_with({1.0 + a, a, a - 1.0}, random) : tensor_with({1.0 + a, a, a}, random);
    }
    for (std::size_t c = 0; c < 6; ++c) {
      std::array<double, pack_size> column;
      for (std::size_t k = 0; k < pack_size; ++k) column[k] = points[k].m[c];
      packed.m[c] = Pack::load(column.data());
    }
    const auto values = principal_values(packed);
    for (std::size_t i = 0; i < 3; ++i) {
      std::array<double, pack_size> lane;
      values[i].store(lane.data());
      for (std::size_t k = 0; k < pack_size; ++k) {
        EXPECT_NEAR(lane[k], spectral(points[k]).values[static_cast<int>(i)], 1e-7);
        EXPECT_NEAR(principal_values(points[k])[i], lane[k], 1e-7);
      }
    }
  }
}

} // namespace
} // namespace riedel::test
