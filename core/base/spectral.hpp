/// Principal values and directions of symmetric tensors.
#pragma once

#include "core/base/tensor.hpp"

namespace riedel {

/// a = Σ values_i v_i ⊗ v_i, largest value first; the columns of `directions` are the unit vectors v_i.
struct Spectral {
  Vec<3> values;
  Mat<3> directions;
};

/// Accurate to round-off, also for equal values. A tensor that is not finite gives values that are not finite.
Spectral spectral(const Sym<double>& a);

/// Σ values_i v_i ⊗ v_i.
Sym<double> from_spectral(const Vec<3>& values, const Mat<3>& directions);

/// The tensor with the same directions whose principal values are f(those of a): an isotropic tensor function.
template <class F>
Sym<double> isotropic_function(const Spectral& a, const F& f) {
  return from_spectral({f(a.values[0]), f(a.values[1]), f(a.values[2])}, a.directions);
}

/// a b a
Sym<double> congruent(const Sym<double>& a, const Sym<double>& b);

/// Principal values alone, largest first, also for packs; nearly equal values are accurate to 1e-8 of the deviator
/// only.
template <class Real>
std::array<Real, 3> principal_values(const Sym<Real>& a) {
  const Sym<Real> s = deviator(a);
  const Real mean = trace(a) * Real(1.0 / 3.0), radius = Real(std::sqrt(2.0 / 3.0)) * norm(s);
  const Real angle = acos(-cos_3_lode(s)) * Real(1.0 / 3.0), third(2.0 * std::numbers::pi / 3.0);
  return {mean + radius * cos(angle), mean + radius * cos(angle - third), mean + radius * cos(angle + third)};
}

} // namespace riedel
