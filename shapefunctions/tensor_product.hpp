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

/// Lanes of doubles along one axis: the point's coordinate, cell size and half width of its domain [m].
struct AxisLanes {
  Pack position, half_width;
};

/// Fills one group of eight points. The nodes taken along an axis are those that lie less than h + l from the point,
/// `nodes_per_axis` of them at the most.
/// @param lanes position and half width along each axis   @param function (r, h, l) -> ValueSlope<Pack>
template <int Dim, class Function>
void fill_tensor_product(const Grid<Dim>& grid, const std::array<AxisLanes, Dim>& lanes, int nodes_per_axis,
                         StencilGroup<Dim>& group, const Function& function) {
  constexpr int most = 4;
  std::array<std::array<ValueSlope<Pack>, most>, Dim> factor;
  std::array<std::array<Index, pack_size>, Dim> first;
  group.lost.fill(false);

  for (std::size_t a = 0; a < Dim; ++a) {
    const Pack h(grid.cell[a]), x = lanes[a].position - Pack(grid.origin[a]), l = lanes[a].half_width;
    // Node i is reached when x − l − h < i h < x + l + h, so the first one is ⌊(x − l)/h⌋.
    const Pack per_cell(1.0 / grid.cell[a]), place = x * per_cell, lowest = floor(place - l * per_cell);
    std::array<double, pack_size> low{};
    lowest.store(low.data());
    for (std::size_t k = 0; k < pack_size; ++k) {
      const bool inside = low[k] >= 0.0 && low[k] + nodes_per_axis <= grid.nodes[a]; // false for NaN too
      group.lost[k] = group.lost[k] || !inside;
      first[a][k] = inside ? static_cast<Index>(low[k]) : 0;
    }
    for (std::size_t i = 0; i < static_cast<std::size_t>(nodes_per_axis); ++i)
      // From the same quotient as the floor, so that a point on a node lies on one side of it for certain.
      factor[a][i] = function((place - (lowest + Pack(static_cast<double>(i)))) * h, h, l);
  }

  const Counts<Dim> strides = grid.strides();
  group.count = power(nodes_per_axis, Dim);
  group.lowest_row = *std::min_element(first[Dim - 1].begin(), first[Dim - 1].end());
  group.highest_row = *std::max_element(first[Dim - 1].begin(), first[Dim - 1].end()) + nodes_per_axis - 1;
  std::array<Index, pack_size> base{};
  for (std::size_t k = 0; k < pack_size; ++k)
    for (std::size_t a = 0; a < Dim; ++a) base[k] += first[a][k] * strides[a];

  for (int entry = 0; entry < group.count; ++entry) {
    std::array<std::size_t, Dim> i{};
    Index offset = 0;
    for (int a = 0, rest = entry; a < Dim; ++a, rest /= nodes_per_axis) {
      i[a] = static_cast<std::size_t>(rest % nodes_per_axis);
      offset += static_cast<Index>(i[a]) * strides[a];
    }
    Pack N(1.0);
    for (std::size_t a = 0; a < Dim; ++a) N *= factor[a][i[a]].value;
    group.set_value(entry, N);
    for (std::size_t a = 0; a < Dim; ++a) {
      Pack dN = factor[a][i[a]].slope;
      for (std::size_t b = 0; b < Dim; ++b)
        if (b != a) dN *= factor[b][i[b]].value;
      group.set_slope(entry, static_cast<int>(a), dN);
    }
    for (int k = 0; k < pack_size; ++k) group.set_node(entry, k, base[k] + offset);
  }
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
