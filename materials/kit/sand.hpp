/// Common part of the hypoplastic laws: the parameters of a sand, and the factors of pressure and density. Gudehus
/// (1996) and Bauer (1996), Soils and Foundations 36(1); equations (A8) to (A10) are those of
/// docs/theory/gudehus_bauer.md, where (8) gives the factors in the form used here.
#pragma once

#include "materials/kit/rate_law.hpp"

namespace riedel {

/// Factors of pressure and density.
template <class Real>
struct SandFactors {
  Real f_s, f_d; ///< (A8) [Pa], [-]
  Real e_bar;    ///< the equivalent void ratio at zero pressure: e_d0 ≤ e_bar ≤ e_i0
};

struct Sand {
  /// Values of a certain sand, the defaults of a law.
  struct Defaults {
    double phi_c, h_s, n, e_i0, e_d0, e_c0, alpha, beta;
  };
  double sin_phi_c;         ///< of the critical angle of friction
  double h_s, n;            ///< granular hardness [Pa], exponent of compression
  double e_i0, e_d0, e_c0;  ///< maximum, minimum and critical void ratio at zero pressure
  double alpha, beta;       ///< exponents of density and of stiffness
  double grain_density;     ///< ρ_s [kg/m³]
  double max_f_d;           ///< f_d for e = e_i, at any pressure
  double per_h_s, per_e_i0; ///< 1/h_s, 1/e_i0
  double per_e_range;       ///< 1/(e_c0 − e_d0)

  /// The parameters above, and those of the integration.
  static Keys keys(const Defaults& defaults);
  /// Throws InputError, in the name of the law, for inadmissible values.
  Sand(const Values& given, std::string_view law);

  [[nodiscard]] double density(double e) const { return grain_density / (1.0 + e); } ///< ρ_s/(1 + e)
  /// @param bracket by which a law divides f_s, so that isotropic compression on e = e_i keeps e_i @return f_s0 [Pa]
  [[nodiscard]] double stiffness(double bracket) const { return h_s / (n * bracket); }
  /// @param P −tr σ [Pa]   @param e void ratio   @param f_s0 the law's `stiffness` [Pa]
  template <class Real>
  SandFactors<Real> factors(const Real& P, const Real& e, double f_s0) const;
};

/// With the equivalent void ratio at zero pressure, e_bar = e exp[(P/h_s)^n], the bounds of (A10) are constants in
/// (A8): no division is left, and the powers share the logarithm of the pressure.
template <class Real>
SandFactors<Real> Sand::factors(const Real& P, const Real& e, double f_s0) const {
  const Real log_pressure = log(Real(per_h_s) * P);
  const Real x = exp(Real(n) * log_pressure), grow = exp(x), e_bar = e * grow; // (A10): grow = e_i0/e_i = e_d0/e_d = …
  const Real one_plus_e_i_over_e_i = Real(1.0) + Real(per_e_i0) * grow;
  const Real f_s = Real(f_s0) * one_plus_e_i_over_e_i * // (A8), (e_i/e)^β (P/h_s)^{1−n} as one power
                   exp(Real(1.0 - n) * log_pressure - Real(beta) * (log(Real(per_e_i0) * e) + x));
  const Real f_d = pow(max(Real(0.0), Real(per_e_range) * (e_bar - Real(e_d0))), Real(alpha)); // (A8)
  return {.f_s = f_s, .f_d = f_d, .e_bar = e_bar};
}

} // namespace riedel
