/// Makes a scheme from a function of one variable: N_ip = Π_a N(x_a − x_ia), ∇N by the product rule.
#pragma once

#include "core/interface/shape_function.hpp"

namespace riedel {

/// A function's value and its derivative with respect to the distance from the node.
template <class Real>
struct ValueSlope {
  Real value; ///< [-]
  Real slope; ///< [1/m]
};

/// Eight points along one axis: coordinate and half width of the domain [m].
struct AxisLanes {
  Pack position, half_width;
};

/// What a function of one variable needs besides the distance.
struct Axis {
  Pack h, per_h;  ///< cell size [m] and 1/h
  Pack l, per_2l; ///< half width of the points' domains [m] and 1/(2 l)
};

/// Weights of the product's nodes, the first axis fastest.
template <int Nodes>
void fill_products(const std::array<std::array<ValueSlope<Pack>, Nodes>, 2>& factor, const Counts<2>& strides,
                   StencilGroup<2>& group, const std::array<Index, pack_size>& base) {
  const auto& [x, y] = factor;
  for (int j = 0, entry = 0; j < Nodes; ++j)
    for (int i = 0; i < Nodes; ++i, ++entry) {
      group.set_value(entry, x[i].value * y[j].value);
      group.set_slope(entry, 0, x[i].slope * y[j].value);
      group.set_slope(entry, 1, x[i].value * y[j].slope);
      group.set_nodes(entry, base, i + j * strides[1]);
    }
}
template <int Nodes>
void fill_products(const std::array<std::array<ValueSlope<Pack>, Nodes>, 3>& factor, const Counts<3>& strides,
                   StencilGroup<3>& group, const std::array<Index, pack_size>& base) {
  const auto& [x, y, z] = factor;
  for (int k = 0, entry = 0; k < Nodes; ++k)
    for (int j = 0; j < Nodes; ++j) {
      const Pack yz = y[j].value * z[k].value, dyz = y[j].slope * z[k].value, ydz = y[j].value * z[k].slope;
      for (int i = 0; i < Nodes; ++i, ++entry) {
        group.set_value(entry, x[i].value * yz);
        group.set_slope(entry, 0, x[i].slope * yz);
        group.set_slope(entry, 1, x[i].value * dyz);
        group.set_slope(entry, 2, x[i].value * ydz);
        group.set_nodes(entry, base, i + j * strides[1] + k * strides[2]);
      }
    }
}

/// Fills one group of eight points. The nodes taken along an axis are the first `Nodes` that lie less than h + l from
/// the point.
/// @param lanes position and half width along each axis   @param function (r, axis) -> ValueSlope<Pack>
template <int Dim, int Nodes, class Function>
void fill_tensor_product(const Grid<Dim>& grid, const std::array<AxisLanes, Dim>& lanes, StencilGroup<Dim>& group,
                         const Function& function) {
  std::array<std::array<ValueSlope<Pack>, Nodes>, Dim> factor;
  std::array<std::array<Index, pack_size>, Dim> first;
  std::array<Index, pack_size> lost{}, base{};
  const Counts<Dim> strides = grid.strides();

  for (int a = 0; a < Dim; ++a) {
    const Axis axis{.h = grid.cell[a],
                    .per_h = 1.0 / grid.cell[a],
                    .l = lanes[a].half_width,
                    .per_2l = Pack(0.5) / lanes[a].half_width};
    // Node i is reached when x − l − h < i h < x + l + h, so the first one is ⌊(x − l)/h⌋.
    const Pack place = (lanes[a].position - Pack(grid.origin[a])) * axis.per_h;
    const Pack lowest = floor(place - axis.l * axis.per_h);
    std::array<double, pack_size> low{};
    lowest.store(low.data());
    const double last = grid.nodes[a] - Nodes;
    for (int k = 0; k < pack_size; ++k) {
      const bool inside = low[k] >= 0.0 && low[k] <= last; // false for NaN too
      lost[k] |= inside ? 0 : 1;
      first[a][k] = static_cast<Index>(inside ? low[k] : 0.0);
      base[k] += first[a][k] * strides[a];
    }
    // From the same quotient as the floor, so that a point on a node lies on one side of it for certain.
    const Pack from_first = (place - lowest) * axis.h;
    for (int i = 0; i < Nodes; ++i) factor[a][i] = function(from_first - Pack(static_cast<double>(i)) * axis.h, axis);
  }

  group.count = power(Nodes, Dim);
  for (int k = 0; k < pack_size; ++k) {
    group.lost[k] = lost[k] != 0;
    group.lowest[k] = first[Dim - 1][k];
    group.highest[k] = first[Dim - 1][k] + Nodes - 1;
  }
  fill_products<Nodes>(factor, strides, group, base);
  group.drop_lost_lanes();
}

/// Eight numbers of a column from point p on; lanes past the column's end repeat its last number.
inline Pack load_lanes(const double* column, Index p, Index size) {
  if (p + pack_size <= size) return Pack::load(column + p);
  std::array<double, pack_size> lane;
  for (Index k = 0; k < pack_size; ++k) lane[k] = column[std::min(p + k, size - 1)];
  return Pack::load(lane.data());
}

} // namespace riedel
