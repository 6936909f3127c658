#pragma once

#include "materials/hypoplastic.hpp"

namespace riedel {

/// Gudehus–Bauer hypoplasticity for a skeleton of sand grains.
/// Gudehus (1996) and Bauer (1996), Soils and Foundations 36(1); equations (A1)–(A10) of Krzyżanowski, Wójcik &
/// Tejchman (2020), with h_i of Bauer (1996), which that paper leaves out. Local and non-local: the N-term takes the
/// averaged norm d* where the case gives a length, ‖D‖ otherwise.
class GudehusBauer final : public RateLaw<GudehusBauer, 1> {
public:
  static constexpr std::string_view name = "gudehus_bauer";
  static constexpr bool frictional = true;
  static Keys parameters();
  /// @param given a value for each of `parameters()`; throws InputError for one that the law does not admit
  explicit GudehusBauer(const Values& given);

  /// @param sigma Cauchy stress, tension positive [Pa]   @param D rate of deformation [1/s]   @param d ‖D‖ or d* [1/s]
  template <class Real>
  Rate<Real, 1> rate(const Sym<Real>& sigma, const std::array<Real, 1>& state, const Sym<Real>& D, Real d) const {
    const Real e = state[0];
    return {.stress = stress_rate(parts(sigma, e), D, d), .state = {void_ratio_rate(e, D)}}; // (A1), (A9)
  }
  /// L and N, (A2) to (A8)   @param e void ratio [-]
  template <class Real>
  HypoplasticParts<Real> parts(const Sym<Real>& sigma, const Real& e) const;

  [[nodiscard]] std::span<const StateVariable> states() const override { return states_; }
  [[nodiscard]] std::vector<std::string> nonlocal_variables() const override { return {"rate_norm"}; }
  [[nodiscard]] double density(std::span<const double> state) const override; ///< ρ_s/(1 + e)
  [[nodiscard]] Survey survey(const MaterialBatch& batch) const override;
  [[nodiscard]] SandBounds bounds() const { return {e_d0_, e_i0_, grain_density_}; }

private:
  /// The factors that depend on pressure and density alone.
  template <class Real>
  struct Factors {
    Real f_s, f_d; ///< (A8) [Pa], [-]
    Real e_bar;    ///< the void ratio brought to zero pressure: e_d0 ≤ e_bar ≤ e_i0
  };
  template <class Real>
  Factors<Real> factors(Real P, Real e) const;
  template <class Real>
  Real a1(const Sym<Real>& s_dev) const; ///< (A5)

  double h_s_, n_, e_i0_, e_d0_, e_c0_, alpha_, beta_, grain_density_;
  double c1_, c2_, h_i_;
  double per_h_s_, per_e_i0_, per_e_range_; ///< 1/h_s, 1/e_i0, 1/(e_c0 − e_d0)
  double f_s0_;                             ///< h_s/(n h_i)
  std::vector<StateVariable> states_{{"void_ratio", "-", "volume of the voids over volume of the grains"},
                                     separation_variable()};
};

/// With the void ratio brought to zero pressure, e_bar = e exp[(P/h_s)^n], the bounds of (A10) are constants in (A8):
/// no division is left, and the powers share the logarithm of the pressure.
template <class Real>
auto GudehusBauer::factors(Real P, Real e) const -> Factors<Real> {
  const Real log_pressure = log(Real(per_h_s_) * P);
  const Real x = exp(Real(n_) * log_pressure), grow = exp(x), e_bar = e * grow; // (A10): grow = e_i0/e_i = e_d0/e_d = …
  const Real one_plus_e_i_over_e_i = Real(1.0) + Real(per_e_i0_) * grow;
  const Real f_s = Real(f_s0_) * one_plus_e_i_over_e_i * // (A8), (e_i/e)^β (P/h_s)^{1−n} as one power
                   exp(Real(1.0 - n_) * log_pressure - Real(beta_) * (log(Real(per_e_i0_) * e) + x));
  const Real f_d = pow(max(Real(0.0), Real(per_e_range_) * (e_bar - Real(e_d0_))), Real(alpha_)); // (A8)
  return {.f_s = f_s, .f_d = f_d, .e_bar = e_bar};
}

/// (A5) over its common denominator: x³ cos 3θ = −√6 tr σ̂*³, x = ‖σ̂*‖.
template <class Real>
Real GudehusBauer::a1(const Sym<Real>& s_dev) const {
  const Real squared = dot(s_dev, s_dev), x = sqrt(squared), x_cubed = squared * x;
  const Real cosine =
      clamp(Real(-3.0 * std::numbers::sqrt2 * std::numbers::sqrt3) * determinant(s_dev), -x_cubed, x_cubed);
  const Real a = squared / (Real(c1_) * squared + Real(c2_) * (x_cubed + cosine));
  return select(squared > Real(1e-30), a, Real(1.0 / c1_));
}

template <class Real>
HypoplasticParts<Real> GudehusBauer::parts(const Sym<Real>& sigma, const Real& e) const {
  const Real P = -trace(sigma); // P = 3 p_s
  const Factors<Real> f = factors(P, e);
  const Sym<Real> s = sigma / -P, s_dev = deviator(s); // (A2), (A7)
  const Real a = a1(s_dev);
  return {.s = s,
          .s_dev = s_dev,
          .f_s = f.f_s,
          .f_d = f.f_d,
          .along = a * a, // (A3)
          .across = Real(1.0),
          .radial = a, // (A4)
          .e_bar = f.e_bar};
}

} // namespace riedel
