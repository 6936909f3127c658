#pragma once

#include "core/interface/shape_function.hpp"

namespace riedel {

/// B-splines of the grid, one per node, evaluated at the point. At a wall, the value of the node behind it is
/// extrapolated linearly from the last two rows, so that the last row alone determines the motion at the wall. Steffen,
/// Kirby & Berzins (2008), Int. J. Numer. Meth. Engng 76, 922–948.
template <int Dim>
class QuadraticBspline final : public ShapeFunction<Dim> {
public:
  static constexpr std::string_view name = "bspline2";

  [[nodiscard]] SchemeTraits traits() const override {
    return {.continuous_gradients = true, .order_across_cells = 2, .ends_at_walls = true};
  }
  [[nodiscard]] int max_nodes() const override { return power(3, Dim); }
  [[nodiscard]] int margin() const override { return 1; }
  [[nodiscard]] double mass_cutoff() const override { return 1e-60; }
  void evaluate(const Grid<Dim>& grid, const Points<Dim>& points, Range block, Stencils<Dim>& stencils) const override;
};

template <int Dim>
class CubicBspline final : public ShapeFunction<Dim> {
public:
  static constexpr std::string_view name = "bspline3";

  [[nodiscard]] SchemeTraits traits() const override {
    return {
        .continuous_gradients = true, .order_across_cells = 2, .converges_at_free_faces = true, .ends_at_walls = true};
  }
  [[nodiscard]] int max_nodes() const override { return power(4, Dim); }
  [[nodiscard]] int margin() const override { return 1; }
  [[nodiscard]] double mass_cutoff() const override { return 1e-60; }
  void evaluate(const Grid<Dim>& grid, const Points<Dim>& points, Range block, Stencils<Dim>& stencils) const override;
};

} // namespace riedel
