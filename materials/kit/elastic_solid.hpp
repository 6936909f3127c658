/// Isotropic elasticity and density: the parameters common to solids.
#pragma once

#include "core/base/parameters.hpp"
#include "core/base/tensor.hpp"

namespace riedel {

struct ElasticSolid {
  double lambda, mu; ///< Lamé's constants λ = E ν/((1 + ν)(1 − 2 ν)), μ = E/(2 (1 + ν)) [Pa]
  double density;    ///< at the start [kg/m³]

  static Keys keys(); ///< `youngs_modulus`, `poissons_ratio`, `density`
  explicit ElasticSolid(const Values& given);

  [[nodiscard]] double bulk() const { return lambda + 2.0 / 3.0 * mu; }   ///< K [Pa]
  [[nodiscard]] double longitudinal() const { return lambda + 2.0 * mu; } ///< stiffness without lateral strain [Pa]

  /// λ tr(ε) I + 2 μ ε
  template <class Real>
  [[nodiscard]] Sym<Real> stress(const Sym<Real>& strain) const {
    return Real(2.0 * mu) * strain + (Real(lambda) * trace(strain)) * Sym<Real>::identity();
  }
  [[nodiscard]] Sym<double> strain(const Sym<double>& stress) const {
    return (0.5 / mu) * (stress - (lambda * trace(stress) / (3.0 * bulk())) * Sym<double>::identity());
  }
};

} // namespace riedel
