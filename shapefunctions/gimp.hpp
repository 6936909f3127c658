#pragma once

#include "core/interface/shape_function.hpp"

namespace riedel {

/// Gradients of boxes vanish later than their masses: they miss nodes with less than a share of 1e-12 of a point.
inline constexpr double min_gradient_seen = 1e-10;

/// Uniform GIMP: hats averaged over a box that is a fixed share of a cell.
/// Bardenhagen & Kober (2004), Comput. Model. Eng. Sci. 5, 477–495.
template <int Dim>
class Gimp final : public ShapeFunction<Dim> {
public:
  static constexpr std::string_view name = "gimp";

  [[nodiscard]] SchemeTraits traits() const override {
    return {.domain = PointDomain::fixed,
            .continuous_gradients = true,
            .order_across_cells = 1,
            .balances_pressure_on_points = true,
            .translation_error = min_gradient_seen};
  }
  [[nodiscard]] int max_nodes() const override { return power(3, Dim); }
  [[nodiscard]] int margin() const override { return 1; }
  void evaluate(const Grid<Dim>& grid, const Points<Dim>& points, Range block, Stencils<Dim>& stencils) const override;
  [[nodiscard]] Mat<Dim> domain(const Grid<Dim>& grid, const Points<Dim>& points, Index p) const override;
};

/// Contiguous-particle GIMP: the box follows the point's stretch, half width l_a = l_a0 U_aa with U the right stretch
/// of F = R U, so that a rotation does not change it; never wider than a cell. Wallstedt & Guilkey (2008), J. Comput.
/// Phys. 227, 9628–9642; U as in Charlton, Coombs & Augarde (2017).
template <int Dim>
class Cpgimp final : public ShapeFunction<Dim> {
public:
  static constexpr std::string_view name = "cpgimp";

  [[nodiscard]] SchemeTraits traits() const override {
    return {.domain = PointDomain::stretched,
            .continuous_gradients = true,
            .order_across_cells = 1,
            .balances_pressure_on_points = true,
            .translation_error = min_gradient_seen};
  }
  [[nodiscard]] int max_nodes() const override { return power(4, Dim); }
  [[nodiscard]] int margin() const override { return 2; }
  void evaluate(const Grid<Dim>& grid, const Points<Dim>& points, Range block, Stencils<Dim>& stencils) const override;
  [[nodiscard]] Mat<Dim> domain(const Grid<Dim>& grid, const Points<Dim>& points, Index p) const override;
};

} // namespace riedel
