/// Symmetric second-order tensors in three dimensions, in Mandel's notation: six numbers whose dot product is the
/// tensors' double contraction. Order 11, 22, 33, √2·12, √2·13, √2·23.
#pragma once

#include "core/base/pack.hpp"

#include <numbers>

namespace riedel {

template <class Real>
struct Sym {
  std::array<Real, 6> m; ///< Mandel components

  static Sym zero() { return {{Real(0.0), Real(0.0), Real(0.0), Real(0.0), Real(0.0), Real(0.0)}}; }
  static Sym identity() { return {{Real(1.0), Real(1.0), Real(1.0), Real(0.0), Real(0.0), Real(0.0)}}; }
};

/// Index of component ij among the six.
constexpr std::size_t mandel(int i, int j) { return static_cast<std::size_t>(i == j ? i : i + j + 2); }

template <class Real>
Sym<Real> operator+(const Sym<Real>& a, const Sym<Real>& b) {
  Sym<Real> c;
  for (std::size_t i = 0; i < 6; ++i) c.m[i] = a.m[i] + b.m[i];
  return c;
}
template <class Real>
Sym<Real> operator-(const Sym<Real>& a, const Sym<Real>& b) {
  Sym<Real> c;
  for (std::size_t i = 0; i < 6; ++i) c.m[i] = a.m[i] - b.m[i];
  return c;
}
template <class Real>
Sym<Real> operator*(const std::type_identity_t<Real>& s, const Sym<Real>& a) {
  Sym<Real> c;
  for (std::size_t i = 0; i < 6; ++i) c.m[i] = s * a.m[i];
  return c;
}
template <class Real>
Sym<Real> operator/(const Sym<Real>& a, const std::type_identity_t<Real>& s) {
  return (Real(1.0) / s) * a;
}

template <class Real>
Real trace(const Sym<Real>& a) {
  return a.m[0] + a.m[1] + a.m[2];
}
template <class Real>
Sym<Real> deviator(const Sym<Real>& a) {
  const Real mean = trace(a) * Real(1.0 / 3.0);
  return {{a.m[0] - mean, a.m[1] - mean, a.m[2] - mean, a.m[3], a.m[4], a.m[5]}};
}
template <class Real>
Real dot(const Sym<Real>& a, const Sym<Real>& b) {
  Real sum = a.m[0] * b.m[0];
  for (std::size_t i = 1; i < 6; ++i) sum += a.m[i] * b.m[i];
  return sum;
}
template <class Real>
Real norm(const Sym<Real>& a) {
  return sqrt(dot(a, a));
}
template <class Real>
Real determinant(const Sym<Real>& a) {
  const Real half(0.5); // a Mandel shear component is √2 times the tensor's
  return a.m[0] * a.m[1] * a.m[2] + Real(std::numbers::sqrt2 / 2) * a.m[3] * a.m[4] * a.m[5] -
         half * (a.m[0] * a.m[5] * a.m[5] + a.m[1] * a.m[4] * a.m[4] + a.m[2] * a.m[3] * a.m[3]);
}

template <class Real>
Real clamp(const Real& x, const Real& low, const Real& high) {
  return min(high, max(low, x));
}

/// cos 3θ = −√6 tr(a³) / tr(a²)^{3/2} of a deviator, clamped to [−1, 1]; −1 where the deviator vanishes.
template <class Real>
Real cos_3_lode(const Sym<Real>& deviator) {
  const Real squared = dot(deviator, deviator);
  const Real cubed = Real(3.0) * determinant(deviator); // tr a³ = 3 det a when tr a = 0
  const Real cosine = Real(-std::numbers::sqrt3 * std::numbers::sqrt2) * cubed / (squared * sqrt(squared));
  return select(squared > Real(1e-30), max(min(cosine, Real(1.0)), Real(-1.0)), Real(-1.0));
}

inline Sym<double> to_sym(const Mat<3>& a) {
  const double r = std::numbers::sqrt2 / 2;
  return {{a(0, 0), a(1, 1), a(2, 2), r * (a(0, 1) + a(1, 0)), r * (a(0, 2) + a(2, 0)), r * (a(1, 2) + a(2, 1))}};
}
inline Mat<3> to_matrix(const Sym<double>& s) {
  const double r = std::numbers::sqrt2 / 2;
  Mat<3> a;
  a << s.m[0], r * s.m[3], r * s.m[4], r * s.m[3], s.m[1], r * s.m[5], r * s.m[4], r * s.m[5], s.m[2];
  return a;
}

} // namespace riedel
