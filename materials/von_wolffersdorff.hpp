#pragma once

#include "materials/hypoplastic.hpp"

namespace riedel {

/// Hypoplasticity of von Wolffersdorff for a skeleton of sand grains: critical states on the surface of Matsuoka and
/// Nakai. P.-A. von Wolffersdorff (1996), Mechanics of Cohesive-Frictional Materials 1, 251–271; numbers (1) to (9) are
/// those of docs/theory/von_wolffersdorff.md. The N-term takes the averaged norm d* where the case gives a length, ‖D‖
/// otherwise.
class VonWolffersdorff final : public RateLaw<VonWolffersdorff, 1> {
public:
  static constexpr std::string_view name = "von_wolffersdorff";
  static constexpr bool frictional = true;
  static Keys parameters();
  /// @param given a value for each of `parameters()`; throws InputError for one that the law does not admit
  explicit VonWolffersdorff(const Values& given);

  /// @param sigma Cauchy stress, tension positive [Pa]   @param D rate of deformation [1/s]   @param d ‖D‖ or d* [1/s]
  template <class Real>
  Rate<Real, 1> rate(const Sym<Real>& sigma, const std::array<Real, 1>& state, const Sym<Real>& D, Real d) const {
    const Real e = state[0];
    return {.stress = stress_rate(parts(sigma, e), D, d), .state = {void_ratio_rate(e, D)}}; // (1), (9)
  }
  /// L and N, (2) to (8)   @param e void ratio [-]
  template <class Real>
  HypoplasticParts<Real> parts(const Sym<Real>& sigma, const Real& e) const;

  [[nodiscard]] std::span<const StateVariable> states() const override { return states_; }
  [[nodiscard]] std::vector<std::string> nonlocal_variables() const override { return {"rate_norm"}; }
  [[nodiscard]] double density(std::span<const double> state) const override; ///< ρ_s/(1 + e)
  [[nodiscard]] Survey survey(const MaterialBatch& batch) const override;
  [[nodiscard]] SandBounds bounds() const { return {e_d0_, e_i0_, grain_density_}; }

private:
  /// (5)   @param squared ‖σ̂*‖²
  template <class Real>
  Real F(const Sym<Real>& s_dev, const Real& squared) const;

  double h_s_, n_, e_i0_, e_d0_, e_c0_, alpha_, beta_, grain_density_;
  double a_, f0_;                           ///< (4); h_s/n over the bracket of (8) [Pa]
  double per_h_s_, per_e_i0_, per_e_range_; ///< 1/h_s, 1/e_i0, 1/(e_c0 − e_d0)
  std::vector<StateVariable> states_{{"void_ratio", "-", "volume of the voids over volume of the grains"},
                                     separation_variable()};
};

/// With tan ψ = √3 x, x = ‖σ̂*‖, and x³ cos 3ϑ = −√6 tr σ̂*³. Beyond x² = 2/3, where a principal stress is tensile, F
/// would be negative; it is zero there.
template <class Real>
Real VonWolffersdorff::F(const Sym<Real>& s_dev, const Real& squared) const {
  const Real x = sqrt(squared), x_cubed = squared * x;
  const Real cosine =
      clamp(Real(-3.0 * std::numbers::sqrt2 * std::numbers::sqrt3) * determinant(s_dev), -x_cubed, x_cubed);
  const Real above = max(Real(0.0), Real(2.0) - Real(3.0) * squared) * squared;
  const Real below = Real(2.0) * squared + Real(std::numbers::sqrt2 * std::numbers::sqrt3) * cosine;
  const Real share = select(squared > Real(1e-30), above / max(below, Real(1e-60)), Real(1.0));
  return sqrt(Real(3.0 / 8.0) * squared + share) - Real(std::numbers::sqrt3 / (2.0 * std::numbers::sqrt2)) * x;
}

/// With e_bar = e exp[(P/h_s)^n] the bounds of (6) are constants in (7) and (8).
template <class Real>
HypoplasticParts<Real> VonWolffersdorff::parts(const Sym<Real>& sigma, const Real& e) const {
  const Real P = -trace(sigma), log_pressure = log(Real(per_h_s_) * P);
  const Real grow = exp(exp(Real(n_) * log_pressure)), e_bar = e * grow; // (6): e_i0/e_i = e_d0/e_d = e_c0/e_c = grow
  const Real f_d = pow(max(Real(0.0), Real(per_e_range_) * (e_bar - Real(e_d0_))), Real(alpha_)); // (7)
  const Real f_b_f_e = Real(f0_) * (Real(1.0) + Real(per_e_i0_) * grow) * // (7), (8): one power of e_i0/e_bar is left
                       exp(Real(1.0 - n_) * log_pressure - Real(beta_) * log(Real(per_e_i0_) * e_bar));
  const Sym<Real> s = sigma / -P, s_dev = deviator(s); // (3)
  const Real squared = dot(s_dev, s_dev), strength = F(s_dev, squared);
  return {.s = s,
          .s_dev = s_dev,
          .f_s = f_b_f_e / (squared + Real(1.0 / 3.0)), // σ̂:σ̂ = σ̂*:σ̂* + 1/3
          .f_d = f_d,
          .along = strength * strength,
          .across = Real(a_ * a_),
          .radial = Real(a_) * strength,
          .e_bar = e_bar};
}

} // namespace riedel
