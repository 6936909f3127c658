/// Cohesion, friction and dilatancy with linear softening, and a tension cut-off: common to frictional laws.
#pragma once

#include "core/base/error.hpp"
#include "core/base/pack.hpp"
#include "core/base/parameters.hpp"

#include <numbers>

namespace riedel {

/// Strength of one point, or of eight.
template <class Real>
struct Resistance {
  Real cohesion;            ///< c [Pa]
  Real friction, dilatancy; ///< φ, ψ [rad]
};

/// sin x; packs have no sine function.
template <class Real>
Real sine(const Real& x) {
  return cos(Real(0.5 * std::numbers::pi) - x);
}

class FrictionalStrength {
public:
  static Keys keys();
  /// Throws InputError if residual values exceed peak values, dilatancy exceeds friction, or nothing resists shear.
  FrictionalStrength(const Values& given, std::string_view owner);

  /// c, φ and ψ decrease linearly, from their peak values at κ = 0 to the residual ones.
  template <class Real>
  [[nodiscard]] Resistance<Real> at(const Real& kappa) const {
    const Real share = max(Real(0.0), min(Real(1.0), Real(1.0 / softening_strain_) * kappa));
    const auto between = [&](double peak, double residual) { return Real(peak) + Real(residual - peak) * share; };
    return {.cohesion = between(peak_.cohesion, residual_.cohesion),
            .friction = between(peak_.friction, residual_.friction),
            .dilatancy = between(peak_.dilatancy, residual_.dilatancy)};
  }
  [[nodiscard]] bool softens() const;
  [[nodiscard]] double tension_cutoff() const { return tension_cutoff_; } ///< [Pa]; infinite: none

private:
  Resistance<double> peak_, residual_;
  double softening_strain_, tension_cutoff_;
};

} // namespace riedel
