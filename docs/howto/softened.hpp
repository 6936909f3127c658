#pragma once

#include "shapefunctions/kit/tensor_product.hpp"

namespace riedel {

/// Hats averaged over a box of half a cell around the point, however many points share the cell.
template <int Dim>
class Softened final : public ShapeFunction<Dim> {
public:
  static constexpr std::string_view name = "softened";

  [[nodiscard]] SchemeTraits traits() const override { return {.continuous_gradients = true, .order_across_cells = 1}; }
  [[nodiscard]] int max_nodes() const override { return power(3, Dim); } // three along each axis
  [[nodiscard]] int margin() const override { return 1; }                // a box reaches over its cell's edge

  void evaluate(const Grid<Dim>& grid, const Points<Dim>& points, Range block, Stencils<Dim>& stencils) const override {
    for (Index p = block.begin; p < block.end; p += pack_size) { // eight points at a time
      std::array<AxisLanes, Dim> lanes;
      for (int a = 0; a < Dim; ++a)
        lanes[a] = {.position = load_lanes(points.position[a], p, points.size()),
                    .half_width = Pack(0.25 * grid.cell[a])}; // l: the support is h + l to either side
      fill_tensor_product<Dim, 3>(grid, lanes, stencils.group_of(p),
                                  [](const Pack& s, const Axis& axis) { return at_each_node<3>(s, axis, averaged); });
    }
  }

private:
  /// N(r) = [B(r + l) − B(r − l)]/(2 l) and its gradient, with the hat's integral B(s) = s − s |s|/(2 h) for |s| ≤ h.
  static ValueGradient<Pack> averaged(const Pack& r, const Axis& axis) {
    const Pack from = max(min(r - axis.l, axis.h), -axis.h), to = max(min(r + axis.l, axis.h), -axis.h);
    const Pack area = (to - from) - Pack(0.5) * axis.per_h * (to * abs(to) - from * abs(from));
    return {.value = area * axis.per_2l, .gradient = (abs(from) - abs(to)) * axis.per_h * axis.per_2l};
  }
};

} // namespace riedel
