#pragma once

#include "materials/kit/elastic_solid.hpp"
#include "materials/kit/rate_law.hpp"

namespace riedel {

/// Hooke's law in rates, σ° = λ tr(D) I + 2 μ D; hypo-elastic with the solver's objective rate.
class LinearElastic final : public RateLaw<LinearElastic, 0> {
public:
  static constexpr std::string_view name = "linear_elastic";
  static constexpr bool frictional = false;
  static constexpr bool constant_rate = true;
  static Keys parameters();
  explicit LinearElastic(const Values& given);

  template <class Real>
  Rate<Real, 0> rate(const Sym<Real>&, const std::array<Real, 0>&, const Sym<Real>& D, Real) const {
    return {.stress = solid_.stress(D), .state = {}};
  }

  [[nodiscard]] std::span<const StateVariable> states() const override { return {}; }
  [[nodiscard]] double density(std::span<const double>) const override { return solid_.density; }
  [[nodiscard]] MaterialLimits assess(const MaterialBatch&) const override {
    return {.wave_speed = std::sqrt(solid_.longitudinal() / solid_.density)};
  }

private:
  ElasticSolid solid_;
};

} // namespace riedel
