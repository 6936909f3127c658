#pragma once

#include "materials/kit/hypoplastic.hpp"

namespace riedel {

/// Gudehus–Bauer hypoplasticity for a skeleton of sand grains.
/// Gudehus (1996) and Bauer (1996), Soils and Foundations 36(1); equations (A1)–(A10) of Krzyżanowski, Wójcik &
/// Tejchman (2020), with h_i of Bauer (1996), which that paper omits. Local and non-local: the N-term uses the averaged
/// norm d* if the case gives a length, otherwise ‖D‖.
class GudehusBauer final : public RateLaw<GudehusBauer, 1> {
public:
  static constexpr std::string_view name = "gudehus_bauer";
  static constexpr bool frictional = true;
  static Keys parameters();
  /// @param given a value for each of `parameters()`; throws InputError for an inadmissible value
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
  [[nodiscard]] double density(std::span<const double> state) const override { return sand_.density(state[0]); }
  [[nodiscard]] MaterialLimits assess(const MaterialBatch& batch) const override;
  [[nodiscard]] const Sand& sand() const { return sand_; }

private:
  template <class Real>
  Real a1(const Sym<Real>& s_dev) const; ///< (A5)

  Sand sand_;
  double c1_, c2_; ///< (A6)
  double f_s0_;    ///< h_s/(n h_i) [Pa]
  std::vector<StateVariable> states_{{"void_ratio", "-", "volume of the voids over volume of the grains"},
                                     separation_variable()};
};

/// (A5) with a common denominator: x³ cos 3θ = −√6 tr σ̂*³, x = ‖σ̂*‖.
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
  const SandFactors<Real> f = sand_.factors(P, e, f_s0_);
  const Sym<Real> s = sigma / -P, s_dev = deviator(s); // (A2), (A7)
  const Real a = a1(s_dev);
  return {.s = s,
          .s_dev = s_dev,
          .f_s = f.f_s,
          .f_d = f.f_d,
          .c_I = a * a, // (A3)
          .c_ss = Real(1.0),
          .c_N = a, // (A4)
          .e_bar = f.e_bar};
}

} // namespace riedel
