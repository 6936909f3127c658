/// Builds a scheme from a function of one variable: N_ip = Π_a N(x_a − x_ia), ∇N by the product rule.
#pragma once

#include "core/interface/shape_function.hpp"
#include "shapefunctions/kit/product_stencil.hpp"

namespace riedel {

/// Eight points along one axis: coordinate and half width of the domain [m].
struct AxisLanes {
  Pack position, half_width;
};

/// Inputs of a function of one variable, apart from the position.
struct Axis {
  Pack h, per_h;  ///< cell size [m] and 1/h
  Pack l, per_2l; ///< half width of the points' domains [m] and 1/(2 l)
  Pack first;     ///< index along the axis of the first node
  Walls walls;    ///< of the grid along the axis
};

/// The factors of `Nodes` consecutive nodes, from a function of the distance r [m] from a node.
template <int Nodes, class Function>
std::array<ValueGradient<Pack>, Nodes> at_each_node(const Pack& s, const Axis& axis, const Function& function) {
  std::array<ValueGradient<Pack>, Nodes> factor;
  for (int i = 0; i < Nodes; ++i) factor[i] = function((s - Pack(static_cast<double>(i))) * axis.h, axis);
  return factor;
}

/// Fills one group of eight points. Along an axis, the first `Nodes` nodes closer than h + l to the point are used.
/// @param lanes position and half width along each axis
/// @param function (s, axis) -> the factors of the nodes, s in cells beyond the first node: l/h ≤ s < 1 + l/h
template <int Dim, int Nodes, class Function>
void fill_tensor_product(const Grid<Dim>& grid, const std::array<AxisLanes, Dim>& lanes, StencilGroup<Dim>& group,
                         const Function& function) {
  std::array<std::array<ValueGradient<Pack>, Nodes>, Dim> factor;
  const Counts<Dim> strides = grid.strides();
  Pack base(0.0), row;
  Mask inside;
  for (int a = 0; a < Dim; ++a) {
    Axis axis{.h = grid.cell[a],
              .per_h = 1.0 / grid.cell[a],
              .l = lanes[a].half_width,
              .per_2l = Pack(0.5) / lanes[a].half_width,
              .first = Pack(0.0),
              .walls = grid.walls[a]};
    // Node i is reached when x − l − h < i h < x + l + h, so the first one is ⌊(x − l)/h⌋.
    const Pack place = (lanes[a].position - Pack(grid.origin[a])) * axis.per_h;
    const Pack lowest = floor(place - axis.l * axis.per_h);
    const Mask fits = lowest >= Pack(0.0) && lowest <= Pack(grid.nodes[a] - Nodes); // also false for NaN
    inside = a == 0 ? fits : inside && fits;
    row = select(fits, lowest, Pack(0.0));
    base += row * Pack(strides[a]);
    axis.first = lowest;
    // Compilers may round `place` twice; the bounds hold nevertheless.
    const Pack minimum = axis.l * axis.per_h;
    factor[a] = function(max(minimum, min(place - lowest, minimum + Pack(1.0 - 0x1p-53))), axis);
  }
  fill_products<Nodes>(factor, group);
  set_nodes<Nodes, Dim>(strides, whole_numbers(base), group);
  group.lowest = whole_numbers(row);
  for (int k = 0; k < pack_size; ++k) group.highest[k] = group.lowest[k] + Nodes - 1;
  group.keep_lanes(inside);
}

/// Eight numbers of a column from point p on; lanes past the column's end repeat its last number.
inline Pack load_lanes(const double* column, Index p, Index size) {
  if (p + pack_size <= size) return Pack::load(column + p);
  std::array<double, pack_size> lane;
  for (Index k = 0; k < pack_size; ++k) lane[k] = column[std::min(p + k, size - 1)];
  return Pack::load(lane.data());
}

} // namespace riedel
