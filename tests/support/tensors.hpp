/// Stresses, rates of deformation and rotations to test laws with.
#pragma once

#include "core/base/tensor.hpp"

#include <Eigen/Geometry>
#include <random>

namespace riedel::test {

inline Sym<Pack> packed(const std::array<Sym<double>, pack_size>& tensors) {
  Sym<Pack> all;
  for (std::size_t c = 0; c < 6; ++c) {
    std::array<double, pack_size> lane;
    for (std::size_t k = 0; k < pack_size; ++k) lane[k] = tensors[k].m[c];
    all.m[c] = Pack::load(lane.data());
  }
  return all;
}
inline std::array<Sym<double>, pack_size> unpacked(const Sym<Pack>& all) {
  std::array<Sym<double>, pack_size> tensors;
  for (std::size_t c = 0; c < 6; ++c) {
    std::array<double, pack_size> lane;
    all.m[c].store(lane.data());
    for (std::size_t k = 0; k < pack_size; ++k) tensors[k].m[c] = lane[k];
  }
  return tensors;
}

inline Sym<double> diagonal(double a, double b, double c) { return {{a, b, c, 0.0, 0.0, 0.0}}; }

/// A stress state of sand and a rate of deformation, with all components non-zero.
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
/// A rotation about an inclined axis.
inline Mat<3> slanted_rotation() {
  return (Eigen::AngleAxisd(0.7, Vec<3>(1, 2, -1).normalized()) * Eigen::AngleAxisd(-1.1, Vec<3>(0, 1, 1).normalized()))
      .toRotationMatrix();
}

} // namespace riedel::test
