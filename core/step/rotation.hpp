/// Rigid rotation of stress and of tensor state over a step, and the rotation for the Jaumann rate, σ̇ = σ° + Wσ − σW.
#pragma once

#include "core/base/pack_matrix.hpp"
#include "core/base/tensor.hpp"

namespace riedel {

/// Rotation over Δt by the Cayley transform of W Δt, an exact rotation that is second order in Δt:
/// Q = (I − W Δt/2)⁻¹ (I + W Δt/2), with W the skew part of L.
Mat<3> rotation_of(const Mat<3>& L, double dt);

/// Q a Qᵀ.
Sym<double> rotated(const Sym<double>& a, const Mat<3>& Q);

/// Q of eight points in the plane.
struct PlaneRotation {
  Pack cos_2, sin_2; ///< of twice the rotation angle from axis 2 towards axis 1
};
using SpaceRotation = PackMatrix<3>; ///< Q of eight points

/// Cayley transform for eight points in the plane. @param w W_12 = (L_12 − L_21)/2 [1/s]
inline PlaneRotation cayley(const Pack& w, double dt) {
  const Pack t = Pack(0.5 * dt) * w, scale = Pack(1.0) / (Pack(1.0) + t * t);
  const Pack c = (Pack(1.0) - t * t) * scale, s = Pack(2.0) * t * scale;
  return {.cos_2 = c * c - s * s, .sin_2 = Pack(2.0) * c * s};
}

/// The same in space. @param w the three of W_32, W_13, W_21 [1/s]
inline SpaceRotation cayley(const std::array<Pack, 3>& w, double dt) {
  // With t = w Δt/2 and T x = t × x, Cayley's Q is I + 2 (T + T T)/(1 + t·t).
  std::array<Pack, 3> t;
  for (int i = 0; i < 3; ++i) t[i] = Pack(0.5 * dt) * w[i];
  const Pack scale = Pack(2.0) / (Pack(1.0) + t[0] * t[0] + t[1] * t[1] + t[2] * t[2]);
  SpaceRotation Q;
  for (int i = 0; i < 3; ++i) {
    const int j = (i + 1) % 3, k = (i + 2) % 3;
    Q[i][i] = Pack(1.0) - scale * (t[j] * t[j] + t[k] * t[k]);
    Q[i][j] = scale * (t[i] * t[j] - t[k]);
    Q[j][i] = scale * (t[i] * t[j] + t[k]);
  }
  return Q;
}

/// a ← Q a Qᵀ
inline void rotate(Sym<Pack>& a, const PlaneRotation& Q) {
  const Pack half_sum = Pack(0.5) * (a.m[0] + a.m[1]), half_difference = Pack(0.5) * (a.m[0] - a.m[1]);
  const Pack shear = a.m[3] * Pack(std::numbers::sqrt2 / 2);
  const Pack along = Q.cos_2 * half_difference + Q.sin_2 * shear;
  a.m[0] = half_sum + along;
  a.m[1] = half_sum - along;
  a.m[3] = Pack(std::numbers::sqrt2) * (Q.cos_2 * shear - Q.sin_2 * half_difference);
}
inline void rotate(Sym<Pack>& a, const SpaceRotation& Q) {
  PackMatrix<3> S, QS;
  for (int i = 0; i < 3; ++i) {
    S[i][i] = a.m[i];
    for (int j = 0; j < i; ++j) S[i][j] = S[j][i] = Pack(std::numbers::sqrt2 / 2) * a.m[mandel(i, j)];
  }
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) QS[i][j] = Q[i][0] * S[0][j] + Q[i][1] * S[1][j] + Q[i][2] * S[2][j];
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j <= i; ++j) {
      const Pack rotated = QS[i][0] * Q[j][0] + QS[i][1] * Q[j][1] + QS[i][2] * Q[j][2];
      a.m[mandel(i, j)] = i == j ? rotated : Pack(std::numbers::sqrt2) * rotated;
    }
}

} // namespace riedel
