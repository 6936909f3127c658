#pragma once

#include "core/interface/shape_function.hpp"

namespace riedel {

/// Dual domain material point method: hats at the point, and gradients α ∇S + (1 − α) ∇̃S, where ∇̃S interpolates
/// between gradients averaged around each node and α vanishes on cell faces, so that gradients are continuous. Zhang,
/// Ma & Giguere (2011), J. Comput. Phys. 230, 6379–6398. Averages are taken over the cells that contain material.
template <int Dim>
class Ddmp final : public ShapeFunction<Dim> {
public:
  static constexpr std::string_view name = "ddmp";
  static const Keys& parameters(); ///< alpha

  explicit Ddmp(const Values& options) : alpha_(options.number("alpha")) {}

  [[nodiscard]] SchemeTraits traits() const override {
    return {.continuous_gradients = true, .order_across_cells = 1, .balances_pressure_on_points = true};
  }
  [[nodiscard]] int max_nodes() const override { return power(4, Dim); }
  [[nodiscard]] int margin() const override { return 1; }
  [[nodiscard]] bool supports_affine() const override { return false; } // its weights are hats
  [[nodiscard]] bool gradients_follow_weights() const override { return false; }
  /// How close points come to the node, the filling of the cell above it, and 1 over the filled volume around it.
  [[nodiscard]] int node_data_size() const override { return 3; }
  void prepare(const Grid<Dim>& grid, const Points<Dim>& points, Columns& node_data) const override;
  void evaluate(const Grid<Dim>& grid, const Points<Dim>& points, Range block, Stencils<Dim>& stencils) const override;

private:
  double alpha_; ///< α at the centre of a cell [-]
};

} // namespace riedel
