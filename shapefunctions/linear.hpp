#pragma once

#include "core/interface/shape_function.hpp"

namespace riedel {

/// The standard material point method: multilinear hats evaluated at the point.
/// Sulsky, Chen & Schreyer (1994), Comput. Methods Appl. Mech. Engrg. 118, 179–196.
template <int Dim>
class Linear final : public ShapeFunction<Dim> {
public:
  static constexpr std::string_view name = "linear";

  [[nodiscard]] SchemeTraits traits() const override { return {.balances_pressure_on_points = true}; }
  [[nodiscard]] int max_nodes() const override { return power(2, Dim); }
  [[nodiscard]] int margin() const override { return 0; }
  [[nodiscard]] bool supports_affine() const override { return false; }
  void evaluate(const Grid<Dim>& grid, const Points<Dim>& points, Range block, Stencils<Dim>& stencils) const override;
};

} // namespace riedel
