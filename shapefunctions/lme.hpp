#pragma once

#include "core/interface/shape_function.hpp"

namespace riedel {

/// Local maximum entropy functions at the point: of all weights that reproduce constants and linear fields exactly, the
/// least biased and most local, N_i ∝ exp(−γ |x − x_i|²/h² + λ · (x − x_i)). Arroyo & Ortiz (2006), Int. J. Numer.
/// Meth. Engng 65, 2167–2202. Nodes behind a wall are excluded.
template <int Dim>
class Lme final : public ShapeFunction<Dim> {
public:
  static constexpr std::string_view name = "lme";
  static const Keys& parameters(); ///< gamma

  explicit Lme(const Values& options);

  [[nodiscard]] SchemeTraits traits() const override {
    return {.continuous_gradients = true, .order_across_cells = 1, .ends_at_walls = true};
  }
  [[nodiscard]] int max_nodes() const override { return power(6, Dim); }
  [[nodiscard]] int margin() const override { return 2; }
  [[nodiscard]] double mass_cutoff() const override { return 1e-60; }
  void evaluate(const Grid<Dim>& grid, const Points<Dim>& points, Range block, Stencils<Dim>& stencils) const override;

private:
  double gamma_; ///< γ [-]
  std::array<double, 6>
      fading_; ///< exp(−γ a²) of the nodes of a row, a counted from the lower node of the point's cell [-]
};

} // namespace riedel
