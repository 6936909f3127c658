/// Turns a yield surface and its return mapping, written in principal stresses, into a law for blocks of points.
#pragma once

#include "core/base/spectral.hpp"
#include "materials/kit/batch_group.hpp"
#include "materials/kit/elastic_solid.hpp"

namespace riedel {

/// Gradients of the yield function and of the plastic potential, in principal stresses.
struct FlowDirections {
  Vec<3> normal, flow;
};

/// Parameters of every elastoplastic law, in addition to its strength.
struct ElastoplasticControl {
  ElasticSolid solid;
  bool hencky;            ///< elastic strains are logarithmic; otherwise stress increments with the objective rate
  double nonlocal_factor; ///< m of κ̂ = m κ̄ + (1 − m) κ [-]

  static Keys keys(); ///< those of ElasticSolid, `strain_measure` and `nonlocal_factor`
  explicit ElastoplasticControl(const Values& given);

  /// Stress after a step without plastic flow [Pa].
  /// @param volume_strain ln J at the start of the step   @param strain D Δt
  [[nodiscard]] Sym<double> trial(const Sym<double>& sigma, double volume_strain, const Sym<double>& strain) const;
  /// An upper bound of stiffness over density, in any direction [m²/s²]. @param added by plastic flow [Pa]
  template <class Real>
  [[nodiscard]] Real max_squared_speed(const Sym<Real>& sigma, const Real& volume_strain, double added) const;
  /// Maximum increase of stiffness over the elastic one by non-associated flow [Pa].
  [[nodiscard]] double added_by(const FlowDirections& flow) const;
};

/// x = f(x) for x ≥ 0, from the value `first` of f at zero. @param round_off of f @return NaN if none is found
template <class F>
double fixed_point(const F& f, double first, double round_off);

/// Elastic trial, return mapping, accumulated plastic strain κ, softening by κ or by its average. The softening is
/// implicit in a point's own κ; the average is that of the start of the step.
/// Eight points at a time take the trial; a point that may leave the elastic range is done alone, in principal
/// stresses.
///
/// A law derives from ElastoplasticLaw<Law> and provides, σ_1 ≥ σ_2 ≥ σ_3 being principal stresses, tension positive,
///   bool softens() const;                            whether the strength depends on κ
///   auto strength(const Real& kappa) const;          the strength at κ as the functions below need it
///   Real yield(const std::array<Real, 3>& sigma, const auto& strength) const;    f [Pa], ≤ 0 if admissible
///   FlowDirections directions(const auto& strength) const;      of the smooth part of the surface, for the wave speed
///   Vec<3> returned(const Vec<3>& trial, const auto& strength) const;            the stress after plastic flow
/// with Real = double and Real = Pack for the first two. Flow keeps the principal directions.
template <class Law>
class ElastoplasticLaw : public Material {
public:
  explicit ElastoplasticLaw(const ElastoplasticControl& control) : control_(control) {}

  [[nodiscard]] std::span<const StateVariable> states() const final { return states_; }
  /// The average affects the softening only.
  [[nodiscard]] std::vector<std::string> nonlocal_variables() const final {
    if (law().softens()) return {"plastic_strain"};
    return {};
  }
  [[nodiscard]] double density(std::span<const double> state) const final { ///< ρ_0/J
    return solid().density * std::exp(-state[volume_strain]);
  }
  void integrate(const MaterialBatch& batch, MaterialReport& report) const final;
  [[nodiscard]] MaterialLimits assess(const MaterialBatch& batch) const final;

protected:
  [[nodiscard]] const ElasticSolid& solid() const { return control_.solid; }

private:
  enum : std::size_t { plastic_strain, volume_strain, variables }; ///< columns of the state
  template <class Real>
  using Point = PointState<Real, variables>;

  /// κ̂, the strain that softens.
  template <class Real>
  Real softening_strain(const Real& own, const Real* averaged) const {
    if (!averaged) return own;
    return Real(control_.nonlocal_factor) * *averaged + Real(1.0 - control_.nonlocal_factor) * own;
  }
  Mask stay_elastic(const BatchGroup<Pack, variables>& group) const;
  std::string_view advance(Point<double>& point, const Sym<double>& strain, const double* averaged) const;
  std::string_view flow(Point<double>& point, const Spectral& trial, const double* averaged) const;

  [[nodiscard]] const Law& law() const { return static_cast<const Law&>(*this); }
  ElastoplasticControl control_;
  std::vector<StateVariable> states_{
      {"plastic_strain", "-", "accumulated plastic deviatoric strain κ = ∫ √(2/3) ‖dev D_p‖ dt"},
      {"volume_strain", "-", "logarithm of the volume over the initial volume"}};
};

} // namespace riedel

#include "materials/kit/elastoplastic_integration.ipp"
