#pragma once

#include "materials/kit/elastoplastic_law.hpp"
#include "materials/kit/strength.hpp"

namespace riedel {

/// Linear elasticity with the Mohr–Coulomb yield surface, non-associated flow, linear softening and a tension cut-off.
/// Exact return to faces, edges and apex in principal stresses: de Souza Neto, Perić & Owen (2008), *Computational
/// Methods for Plasticity*, section 8.2; Clausen, Damkilde & Andersen (2006), Int. J. Numer. Meth. Engng 66. Equation
/// numbers are those of docs/theory/mohr_coulomb.md.
class MohrCoulomb final : public ElastoplasticLaw<MohrCoulomb> {
public:
  static constexpr std::string_view name = "mohr_coulomb";
  static Keys parameters();
  explicit MohrCoulomb(const Values& given);

  template <class Real>
  struct Strength {
    Real sin_phi, sin_psi;
    Real cohesive; ///< c cos φ [Pa]
  };
  [[nodiscard]] bool softens() const { return strength_.softens(); }
  template <class Real>
  [[nodiscard]] Strength<Real> strength(const Real& kappa) const {
    const Resistance<Real> at = strength_.at(kappa);
    return {.sin_phi = sine(at.friction), .sin_psi = sine(at.dilatancy), .cohesive = at.cohesion * cos(at.friction)};
  }
  template <class Real>
  [[nodiscard]] Real yield(const std::array<Real, 3>& sigma, const Strength<Real>& s) const {
    return max(shear(sigma[0], sigma[2], s), sigma[0] - Real(strength_.tension_cutoff())); // (1), (2)
  }
  [[nodiscard]] FlowDirections directions(const Strength<double>& s) const { // (3)
    return {.normal = 0.5 * Vec<3>(1.0 + s.sin_phi, 0.0, s.sin_phi - 1.0),
            .flow = 0.5 * Vec<3>(1.0 + s.sin_psi, 0.0, s.sin_psi - 1.0)};
  }
  [[nodiscard]] Vec<3> returned(const Vec<3>& trial, const Strength<double>& s) const;

private:
  template <class Real>
  static Real shear(const Real& sigma_1, const Real& sigma_3, const Strength<Real>& s) {
    return Real(0.5) * (sigma_1 - sigma_3) + Real(0.5) * (sigma_1 + sigma_3) * s.sin_phi - s.cohesive; // (1)
  }
  [[nodiscard]] Vec<3> flow(int maximum, int minimum, const Strength<double>& s) const;
  [[nodiscard]] Vec<3> returned_in_shear(const Vec<3>& trial, const Strength<double>& s) const;
  [[nodiscard]] Vec<3> returned_to_edge(const Vec<3>& trial, const Strength<double>& s, int twin, double a,
                                        double b) const;
  [[nodiscard]] Vec<3> returned_in_tension(const Vec<3>& trial) const;
  [[nodiscard]] Vec<3> returned_to_both(const Vec<3>& trial, const Strength<double>& s) const;

  FrictionalStrength strength_;
};

} // namespace riedel
