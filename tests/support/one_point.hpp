/// One point strained along a path, without a grid.
#pragma once

#include "core/step/rotation.hpp"
#include "support/law.hpp"

#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <gtest/gtest.h>

namespace riedel::test {

inline LawBench one_point(std::shared_ptr<const Material> law, const Sym<double>& sigma = Sym<double>::zero()) {
  LawBench bench(std::move(law), 1);
  bench.put(0, sigma, 0.0, Sym<double>::zero());
  return bench;
}

/// Applies a strain in a number of equal parts.
inline Sym<double> strained(LawBench& bench, const Sym<double>& strain, int slices = 1) {
  bench.put(0, bench.stress_of(0), 0.0, (1.0 / slices) * strain);
  for (int i = 0; i < slices; ++i) bench.integrate(1.0);
  EXPECT_EQ(bench.report.failures, 0) << bench.report.reason;
  return bench.stress_of(0);
}
inline Sym<double> strained(const std::shared_ptr<const Material>& law, const Sym<double>& strain, int slices = 1) {
  LawBench bench = one_point(law);
  return strained(bench, strain, slices);
}

/// Rotates six columns of a point as the solver does.
inline void turn(Columns& columns, int first, const Mat<3>& Q) {
  Sym<double> a;
  for (int i = 0; i < 6; ++i) a.m[static_cast<std::size_t>(i)] = columns[first + i][0];
  a = rotated(a, Q);
  for (int i = 0; i < 6; ++i) columns[first + i][0] = a.m[static_cast<std::size_t>(i)];
}
inline void turn(LawBench& bench, const Mat<3>& Q) {
  turn(bench.stress, 0, Q);
  int column = 0;
  for (const StateVariable& variable : bench.law->states()) {
    if (variable.components == 6) turn(bench.state, column, Q);
    column += variable.components;
  }
}
/// Follows F(s), s from 0 to 1, as the solver does: in each step rotation, then law. With half the rotation before the
/// law and half after it the splitting is of second order, and the error of the law itself remains.
/// @return ∫ J σ:D dt [J/m³]
template <class Path>
double deformed(LawBench& bench, const Path& F, int steps, bool in_halves = false) {
  double work = 0.0;
  for (int i = 0; i < steps; ++i) {
    const Mat<3> before = F(double(i) / steps), after = F((i + 1.0) / steps);
    const Mat<3> L = (after - before) * (0.5 * (before + after)).inverse();
    const Sym<double> D = to_sym(L);
    turn(bench, rotation_of(L, in_halves ? 0.5 : 1.0));
    work += 0.5 * before.determinant() * dot(bench.stress_of(0), D);
    work += 0.5 * after.determinant() * dot(strained(bench, D), D);
    if (in_halves) turn(bench, rotation_of(L, 0.5));
  }
  return work;
}

inline double state_of(const LawBench& bench, std::string_view name) {
  return bench.state[state_column(bench.law->states(), name)][0];
}

/// Strains by `axial` along axis 1 while both lateral stresses stay at `lateral`. @return the axial stress
inline double compressed_triaxially(LawBench& bench, double axial, double lateral) {
  double low = -2.0 * std::abs(axial), high = 2.0 * std::abs(axial);
  for (int i = 0; i < 100; ++i) {
    const double middle = 0.5 * (low + high);
    LawBench probe = bench;
    (strained(probe, diagonal(axial, middle, middle)).m[1] < lateral ? low : high) = middle;
  }
  return strained(bench, diagonal(axial, high, high)).m[0];
}

/// Largest first.
inline Vec<3> principal_stresses(const Sym<double>& sigma) {
  return Eigen::SelfAdjointEigenSolver<Mat<3>>(to_matrix(sigma)).eigenvalues().reverse();
}

inline void expect_stress(const Sym<double>& sigma, const Vec<3>& expected, double tolerance) {
  for (std::size_t i = 0; i < 3; ++i)
    EXPECT_NEAR(sigma.m[i], expected[static_cast<int>(i)], tolerance) << "axis " << i + 1;
  for (std::size_t i = 3; i < 6; ++i) EXPECT_NEAR(sigma.m[i], 0.0, tolerance);
}

/// Rank-one increments from stresses on the yield surface: none may be stiffer than assessed.
inline void expect_no_faster_wave(const std::shared_ptr<const Material>& law, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> unit(-1.0, 1.0);
  double nearest = 0.0;
  for (int trial = 0; trial < 2000; ++trial) {
    LawBench bench = one_point(law, -2e4 * Sym<double>::identity());
    strained(bench, 0.05 * random_rate(random));
    const double c = bench.law->assess(bench.batch).wave_speed;
    const Vec<3> n = Vec<3>(unit(random), unit(random), unit(random)).normalized();
    const Sym<double> D = to_sym((trial % 2 ? 1e-7 : -1e-7) * n * n.transpose()), before = bench.stress_of(0);
    std::vector<double> state;
    for (int s = 0; s < bench.state.components(); ++s) state.push_back(bench.state[s][0]);
    const double stiffness = std::abs(dot(strained(bench, D) - before, D)) / dot(D, D);
    nearest = std::max(nearest, stiffness / bench.law->density(state) / (c * c));
  }
  EXPECT_LE(nearest, 1.0 + 1e-6);
  EXPECT_GT(nearest, 0.7) << "the bound is too wide";
}

} // namespace riedel::test
