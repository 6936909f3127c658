/// Rigid rotation of stress and of tensor state over a step: the W of the Jaumann rate, σ̇ = σ° + Wσ − σW.
#pragma once

#include "core/base/tensor.hpp"

namespace riedel {

/// Rotation over Δt by Cayley's transform of W Δt, an exact rotation that is second order in Δt:
/// Q = (I − W Δt/2)⁻¹ (I + W Δt/2), with W the skew part of L.
Mat<3> rotation_of(const Mat<3>& L, double dt);

/// Q a Qᵀ.
Sym<double> rotated(const Sym<double>& a, const Mat<3>& Q);

/// The same for eight points in the plane. @param w W_12 = (L_12 − L_21)/2 [1/s]
inline void rotate_in_plane(Sym<Pack>& a, const Pack& w, double dt) {
  const Pack t = Pack(0.5 * dt) * w, scale = Pack(1.0) / (Pack(1.0) + t * t);
  const Pack c = (Pack(1.0) - t * t) * scale, s = Pack(2.0) * t * scale;
  const Pack half_sum = Pack(0.5) * (a.m[0] + a.m[1]), half_difference = Pack(0.5) * (a.m[0] - a.m[1]);
  const Pack shear = a.m[3] * Pack(std::numbers::sqrt2 / 2);
  const Pack cos_2 = c * c - s * s, sin_2 = Pack(2.0) * c * s;
  const Pack along = cos_2 * half_difference + sin_2 * shear;
  a.m[0] = half_sum + along;
  a.m[1] = half_sum - along;
  a.m[3] = Pack(std::numbers::sqrt2) * (cos_2 * shear - sin_2 * half_difference);
}

} // namespace riedel
