/// One law at a few points, without a grid.
#pragma once

#include "core/base/tensor.hpp"
#include "core/state/points.hpp"
#include "support/problems.hpp"

#include <Eigen/Geometry>

namespace riedel::test {

/// Points with stress, state and rate of deformation, handed to a law as one batch.
struct LawBench {
  std::shared_ptr<const Material> law;
  Columns stress{6}, rate{6}, state;
  AlignedVector<double> averaged;
  MaterialBatch batch;
  MaterialReport report;

  std::vector<double*> columns;

  LawBench(std::shared_ptr<const Material> given, Index size)
      : law(std::move(given)), state(state_components(law->states())) {
    stress.resize(size);
    rate.resize(size);
    state.resize(size);
  }
  void put(Index p, const Sym<double>& sigma, double void_ratio, const Sym<double>& D) {
    for (std::size_t c = 0; c < 6; ++c) {
      stress[static_cast<int>(c)][p] = sigma.m[c];
      rate[static_cast<int>(c)][p] = D.m[c];
    }
    const int e = state_column(law->states(), "void_ratio");
    if (e >= 0) state[e][p] = void_ratio;
  }
  [[nodiscard]] Sym<double> stress_of(Index p) const {
    Sym<double> s;
    for (std::size_t c = 0; c < 6; ++c) s.m[c] = stress[static_cast<int>(c)][p];
    return s;
  }
  void integrate(double dt) { integrate(dt, {0, stress.size()}); }
  void integrate(double dt, Range part) {
    columns.clear();
    for (int s = 0; s < state.components(); ++s) columns.push_back(state[s] + part.begin);
    batch.size = part.size();
    batch.time_step = dt;
    for (int c = 0; c < 6; ++c) {
      batch.stress[static_cast<std::size_t>(c)] = stress[c] + part.begin;
      batch.rate[static_cast<std::size_t>(c)] = rate[c] + part.begin;
    }
    batch.averaged = averaged.empty() ? nullptr : averaged.data() + part.begin;
    batch.state = columns;
    law->integrate(batch, report);
  }
};

inline Sym<double> diagonal(double a, double b, double c) { return {{a, b, c, 0.0, 0.0, 0.0}}; }

/// A stress state of sand and a rate of deformation, all components at work.
inline Sym<double> random_stress(std::mt19937& random, double pressure) {
  std::uniform_real_distribution<double> unit(-0.25, 0.25);
  Sym<double> s = Sym<double>::identity();
  for (double& component : s.m) component += unit(random);
  return -pressure * s;
}
inline Sym<double> random_rate(std::mt19937& random) {
  std::uniform_real_distribution<double> unit(-1.0, 1.0);
  Sym<double> D;
  for (double& component : D.m) component = unit(random);
  return D;
}
/// A rotation about a slanted axis.
inline Mat<3> slanted_rotation() {
  return (Eigen::AngleAxisd(0.7, Vec<3>(1, 2, -1).normalized()) * Eigen::AngleAxisd(-1.1, Vec<3>(0, 1, 1).normalized()))
      .toRotationMatrix();
}

} // namespace riedel::test
