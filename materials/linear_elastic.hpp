#pragma once

#include "core/interface/rate_law.hpp"

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
    return {.stress = Real(2.0 * mu_) * D + (Real(lambda_) * trace(D)) * Sym<Real>::identity(), .state = {}};
  }

  [[nodiscard]] std::span<const StateVariable> states() const override { return {}; }
  [[nodiscard]] double density(std::span<const double>) const override { return density_; }
  [[nodiscard]] Survey survey(const MaterialBatch&) const override {
    return {.wave_speed = std::sqrt((lambda_ + 2.0 * mu_) / density_)};
  }

private:
  double lambda_, mu_, density_;
};

} // namespace riedel
