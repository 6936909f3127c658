#pragma once

#include "materials/kit/elastoplastic_law.hpp"
#include "materials/kit/strength.hpp"

namespace riedel {

/// Linear elasticity with the cone of Drucker and Prager, matched to the Mohr–Coulomb surface in one of three ways;
/// non-associated flow, linear softening and a cut-off of the mean tension. Exact return to cone and apex: Drucker &
/// Prager (1952), Quart. Appl. Math. 10; de Souza Neto, Perić & Owen (2008), *Computational Methods for Plasticity*,
/// section 8.3. Equation numbers are those of docs/theory/drucker_prager.md.
class DruckerPrager final : public ElastoplasticLaw<DruckerPrager> {
public:
  static constexpr std::string_view name = "drucker_prager";
  static Keys parameters();
  explicit DruckerPrager(const Values& given);

  template <class Real>
  struct Strength {
    Real eta, eta_bar; ///< η and η̄: slopes of the cone and of the potential [-]
    Real cohesive;     ///< ξ c [Pa]
  };
  [[nodiscard]] bool softens() const { return strength_.softens(); }
  template <class Real>
  [[nodiscard]] Strength<Real> strength(const Real& kappa) const;
  template <class Real>
  [[nodiscard]] Real yield(const std::array<Real, 3>& sigma, const Strength<Real>& s) const {
    const Real p = Real(1.0 / 3.0) * (sigma[0] + sigma[1] + sigma[2]);
    const Real a = sigma[0] - p, b = sigma[1] - p, c = sigma[2] - p;
    const Real root_J2 = sqrt(Real(0.5) * (a * a + b * b + c * c));
    return max(root_J2 + s.eta * p - s.cohesive, p - Real(strength_.tension_cutoff())); // (1), (2)
  }
  [[nodiscard]] FlowDirections directions(const Strength<double>& s) const {
    const Vec<3> one = Vec<3>::Ones(), shear(0.5, 0.0, -0.5); // any s/(2 √J_2)
    return {.normal = shear + s.eta / 3.0 * one, .flow = shear + s.eta_bar / 3.0 * one};
  }
  [[nodiscard]] Vec<3> returned(const Vec<3>& trial, const Strength<double>& s) const;

private:
  enum class Cone { compression, extension, plane_strain };

  FrictionalStrength strength_;
  Cone cone_;
};

template <class Real>
auto DruckerPrager::strength(const Real& kappa) const -> Strength<Real> {
  const Resistance<Real> at = strength_.at(kappa);
  const Real sin_phi = sine(at.friction), sin_psi = sine(at.dilatancy), three(3.0);
  const Real potential = three / sqrt(Real(9.0) + three * sin_psi * sin_psi); // √(1 − η̄²/3)
  const Real sign(cone_ == Cone::extension ? 1.0 : -1.0), two_root_three(2.0 * std::numbers::sqrt3);
  const bool plane = cone_ == Cone::plane_strain;
  const Real eta_bar = plane ? sin_psi * potential : two_root_three * sin_psi / (three + sign * sin_psi); // (5), (4)
  const Real scale = plane ? Real(1.0) / (potential + eta_bar * sin_phi / three)                          // (6)
                           : two_root_three / (three + sign * sin_phi);                                   // (3)
  return {.eta = scale * sin_phi, .eta_bar = eta_bar, .cohesive = scale * at.cohesion * cos(at.friction)};
}

} // namespace riedel
