#pragma once

#include "materials/kit/hypoplastic.hpp"

namespace riedel {

/// Parameters of the extension, in addition to those of the law.
struct IntergranularStrainParameters {
  double m_R, m_T;    ///< stiffness after a reversal by 180° and a turn by 90°, relative to monotonic loading [-]
  double R;           ///< radius of the elastic range in the space of strains [-]
  double beta_R, chi; ///< exponents of the evolution of h, and of the stiffness [-]

  static constexpr std::string_view chosen = "intergranular_strain"; ///< the key that switches the extension on
  static Keys keys();
  /// Throws InputError, in the name of the law, for inadmissible values.
  IntergranularStrainParameters(const Values& given, std::string_view law);
};

/// Any hypoplastic law, L:D + N d, with intergranular strain: a tensor h that stores the recent strain, so that the
/// skeleton is stiffer for a while after a change of direction. A. Niemunis & I. Herle (1997), Mechanics of
/// Cohesive-Frictional Materials 2, 279–299; equations (1) to (7) are those of docs/theory/intergranular_strain.md. The
/// extended law contains no norm of D, so nothing in it can be averaged.
template <class Base>
class IntergranularStrain final : public RateLaw<IntergranularStrain<Base>, 7> {
public:
  static constexpr bool frictional = true;
  template <class Real>
  using State = std::array<Real, 7>; ///< e, h

  /// @param given a value for each parameter of the law and each of `IntergranularStrainParameters::keys()`
  explicit IntergranularStrain(const Values& given)
      : RateLaw<IntergranularStrain, 7>(IntegrationControl(given)), base_(given), with_(given, Base::name) {}

  /// @param sigma Cauchy stress, tension positive [Pa]   @param D rate of deformation [1/s]
  template <class Real>
  Rate<Real, 7> rate(const Sym<Real>& sigma, const State<Real>& state, const Sym<Real>& D, Real) const;
  /// ‖Δh‖/R or |Δe|/e, whichever is larger
  template <class Real>
  Real state_change(const State<Real>& from, const State<Real>& to) const {
    return max(norm(strain(to) - strain(from)) * Real(1.0 / with_.R), abs(to[0] - from[0]) / from[0]);
  }
  /// Grains that lose contact lose their intergranular strain.
  void lose_contact(State<double>& state) const { std::fill(state.begin() + 1, state.end(), 0.0); }

  [[nodiscard]] std::span<const StateVariable> states() const override { return states_; }
  [[nodiscard]] double density(std::span<const double> state) const override { return base_.density(state); }
  [[nodiscard]] MaterialLimits assess(const MaterialBatch& batch) const override {
    return assess_sand<7>(base_, batch, [&](const auto& parts) { return stiffness(parts); });
  }

private:
  template <class Real>
  static Sym<Real> strain(const State<Real>& state) {
    return {{state[1], state[2], state[3], state[4], state[5], state[6]}};
  }
  /// An upper bound in any direction and for any h [Pa], (7)
  template <class Real>
  Real stiffness(const HypoplasticParts<Real>& q) const;

  Base base_;
  IntergranularStrainParameters with_;
  std::vector<StateVariable> states_{
      {"void_ratio", "-", "volume of the voids over volume of the grains"},
      {"intergranular_strain", "-", "intergranular strain h, the recent strain of the contacts", 6},
      IntergranularStrain::separation_variable()};
};

/// The direction of h = 0 is undefined but irrelevant: it is multiplied by ρ^χ and ρ^β_R. Round-off may raise ρ
/// slightly above 1; (5) brings it back, and the stiffness uses 1.
template <class Base>
template <class Real>
Rate<Real, 7> IntergranularStrain<Base>::rate(const Sym<Real>& sigma, const State<Real>& state, const Sym<Real>& D,
                                              Real) const {
  const Sym<Real> h = strain(state);
  const Real length = norm(h), log_rho = log(Real(1.0 / with_.R) * length);               // (1)
  const Sym<Real> h_hat = select(length > Real(0.0), Real(1.0) / length, Real(0.0)) * h;  // (1)
  const Real share = exp(Real(with_.chi) * min(log_rho, Real(0.0))), h_D = dot(h_hat, D); // ρ^χ, ĥ:D
  const Real loading = max(h_D, Real(0.0)), reversed = h_D - loading;                     // one is zero
  const Real all = Real(with_.m_R) + share * Real(with_.m_T - with_.m_R);                 // (3)
  const Real along_h = share * (Real(1.0 - with_.m_T) * loading + Real(with_.m_R - with_.m_T) * reversed); // (3)
  const Sym<Real> h_rate = D - exp(Real(with_.beta_R) * log_rho) * loading * h_hat;                        // (5)
  return {.stress = stress_rate(base_.parts(sigma, state[0]), all * D + along_h * h_hat, share * loading), // (2), (4)
          .state = {void_ratio_rate(state[0], D), h_rate.m[0], h_rate.m[1], h_rate.m[2], h_rate.m[3], h_rate.m[4],
                    h_rate.m[5]}};
}

template <class Base>
template <class Real>
Real IntergranularStrain<Base>::stiffness(const HypoplasticParts<Real>& q) const {
  const Real s_nn = max_principal(q), s_squared = dot(q.s, q.s);
  const Real A = q.c_I + q.c_ss * s_nn * s_nn, X = Real(0.5) * q.c_ss * s_squared, r = sqrt(A * A + X * X);
  const Real B = q.f_d * q.c_N * (Real(2.0) * s_nn - Real(1.0 / 3.0));
  return q.f_s * (Real(with_.m_T) * A +
                  max(Real(0.5 * (with_.m_R - with_.m_T)) * (r + A), Real(0.5 * (with_.m_T - 1.0)) * (r - A) + B));
}

} // namespace riedel
