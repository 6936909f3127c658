#pragma once

#include "core/base/spectral.hpp"
#include "materials/kit/batch_group.hpp"
#include "materials/kit/elastic_solid.hpp"

namespace riedel {

/// Compressible neo-Hookean elasticity, W = μ/2 (tr b − 3 − 2 ln J) + λ/2 (ln J)²: Simo & Pister (1984), Comput.
/// Methods Appl. Mech. Engng 46; Bonet & Wood (2008), *Nonlinear Continuum Mechanics for Finite Element Analysis*,
/// section 6.4.3. The left Cauchy–Green tensor b is tensor state: the solver rotates it, the law stretches it. Equation
/// numbers are those of docs/theory/neo_hookean.md.
class NeoHookean final : public Material {
public:
  static constexpr std::string_view name = "neo_hookean";
  static Keys parameters();
  explicit NeoHookean(const Values& given);

  /// Cauchy stress [Pa]
  [[nodiscard]] Sym<double> stress(const Sym<double>& b) const;
  /// The b whose stress is `sigma`, from the stress-free state without rotation; not finite if there is none.
  [[nodiscard]] Sym<double> stretch_under(const Sym<double>& sigma) const;

  [[nodiscard]] std::span<const StateVariable> states() const override { return states_; }
  [[nodiscard]] double density(std::span<const double> state) const override; ///< ρ_0/J, J since the start
  void integrate(const MaterialBatch& batch, MaterialReport& report) const override;
  [[nodiscard]] MaterialLimits assess(const MaterialBatch& batch) const override;

private:
  enum : std::size_t { volume_strain = 6, variables }; ///< the column after those of b
  using Point = PointState<double, variables>;
  /// b of a point; before the point first moves, it is computed from its stress.
  [[nodiscard]] Sym<double> stretch_of(const Point& point) const;

  ElasticSolid solid_;
  std::vector<StateVariable> states_{
      {"left_cauchy_green", "-", "b = F Fᵀ from the unstressed state; all zero until the point first deforms", 6},
      {"volume_strain", "-", "logarithm of the volume over the initial volume"}};
};

} // namespace riedel
