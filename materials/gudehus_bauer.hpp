#pragma once

#include "core/interface/rate_law.hpp"

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
  Rate<Real, 1> rate(const Sym<Real>& sigma, const std::array<Real, 1>& state, const Sym<Real>& D, Real d) const;

  [[nodiscard]] std::span<const StateVariable> states() const override { return states_; }
  [[nodiscard]] std::vector<std::string> nonlocal_variables() const override { return {"rate_norm"}; }
  [[nodiscard]] double density(std::span<const double> state) const override; ///< ρ_s/(1 + e)
  [[nodiscard]] Survey survey(const MaterialBatch& batch) const override;

private:
  /// The factors that depend on pressure and density alone.
  template <class Real>
  struct Factors {
    Real f_s, f_d; ///< (A8) [Pa], [-]
    Real e_d, e_i; ///< bounds of the void ratio at this pressure, (A10)
  };
  template <class Real>
  Factors<Real> factors(Real P, Real e) const;
  template <class Real>
  Real a1(const Sym<Real>& s_dev) const; ///< (A5)

  double h_s_, n_, e_i0_, e_d0_, e_c0_, alpha_, beta_, grain_density_;
  double c1_, c2_, h_i_;
  std::vector<StateVariable> states_{{"void_ratio", "-", "volume of the voids over volume of the grains"},
                                     separation_variable()};
};

template <class Real>
auto GudehusBauer::factors(Real P, Real e) const -> Factors<Real> {
  const Real pressure = P / Real(h_s_), power_n = pow(pressure, Real(n_));
  const Real shrink = exp(-power_n);                                                             // (A10)
  const Real e_i = Real(e_i0_) * shrink, e_d = Real(e_d0_) * shrink, e_c = Real(e_c0_) * shrink; // (A10)
  const Real f_s = Real(h_s_ / (n_ * h_i_)) * pow(e_i / e, Real(beta_)) * (Real(1.0) + e_i) / e_i *
                   (pressure / power_n);                                       // (A8), (P/h_s)^{1−n}
  const Real f_d = pow(max((e - e_d) / (e_c - e_d), Real(0.0)), Real(alpha_)); // (A8)
  return {.f_s = f_s, .f_d = f_d, .e_d = e_d, .e_i = e_i};
}

template <class Real>
Real GudehusBauer::a1(const Sym<Real>& s_dev) const {
  return Real(1.0) / (Real(c1_) + Real(c2_) * norm(s_dev) * (Real(1.0) + cos_3_lode(s_dev))); // (A5)
}

template <class Real>
Rate<Real, 1> GudehusBauer::rate(const Sym<Real>& sigma, const std::array<Real, 1>& state, const Sym<Real>& D,
                                 Real d) const {
  const Real P = -trace(sigma), e = state[0]; // P = 3 p_s
  const Factors<Real> f = factors(P, e);
  const Sym<Real> s = sigma / trace(sigma), s_dev = deviator(s); // (A2), (A7)
  const Real a = a1(s_dev);
  const Sym<Real> L = a * a * D + dot(s, D) * s;                                         // (A3)
  const Sym<Real> N = a * (s + s_dev);                                                   // (A4)
  return {.stress = f.f_s * (L + f.f_d * d * N), .state = {(Real(1.0) + e) * trace(D)}}; // (A1), (A9)
}

} // namespace riedel
