/// Stencils of domains with known corners: the hats are interpolated between the corners of a quadrilateral
/// (hexahedron), so that each corner adds the nodes of its cell with its own weights.
#pragma once

#include "core/interface/shape_function.hpp"

namespace riedel {

template <int Dim>
using PackVector = std::array<Pack, Dim>;

constexpr int corner_sign(int corner, int axis) { return (corner >> axis) & 1 ? 1 : -1; } ///< s_ca, as (±1, …)

/// One corner of eight domains.
template <int Dim>
struct Corner {
  PackVector<Dim> place;
  Pack weight;              ///< of the corner's value in the mean over the domain
  PackVector<Dim> gradient; ///< the same for the mean gradient
};

/// Factor that limits a vector's length to `longest`.
template <int Dim>
Pack shortening(const PackVector<Dim>& l, const Pack& longest) {
  Pack squared(0.0);
  for (const Pack& component : l) squared += component * component;
  return longest / max(sqrt(squared), longest);
}

/// Extent of the corners of eight domains.
struct Reach {
  Pack lowest, highest; ///< index along the last axis of the nodes
  Mask inside;          ///< whether all are on the grid
};

/// Weights of eight points for the nodes of a corner's cell, which form a patch: its weight times their hats.
template <int Dim>
void add_corner(const Grid<Dim>& grid, int number, const Corner<Dim>& corner, const StencilEntries<Dim>& entries,
                Reach& reach) {
  constexpr int nodes = power(2, Dim);
  PackVector<Dim> xi; // position in the corner's cell, 0 to 1
  const Counts<Dim> strides = grid.strides();
  Pack base(0.0), row;
  for (int a = 0; a < Dim; ++a) {
    const Pack place = (corner.place[a] - Pack(grid.origin[a])) * Pack(1.0 / grid.cell[a]), lowest = floor(place);
    const Mask fits = lowest >= Pack(0.0) && lowest <= Pack(grid.nodes[a] - 2); // also false for NaN
    xi[a] = place - lowest;
    row = select(fits, lowest, Pack(0.0));
    base += row * Pack(strides[a]);
    reach.inside = reach.inside && fits;
  }
  reach.lowest = min(reach.lowest, row);
  reach.highest = max(reach.highest, row + Pack(1.0));

  entries.set_base(number, whole_numbers(base));
  for (int n = 0; n < nodes; ++n) {
    const int entry = number * nodes + n;
    Pack N(1.0);
    for (int a = 0; a < Dim; ++a) N *= (n >> a) & 1 ? xi[a] : Pack(1.0) - xi[a];
    entries.set_value(entry, N * corner.weight);
    for (int a = 0; a < Dim; ++a) entries.set_gradient(entry, a, N * corner.gradient[a]);
  }
}

/// Fills one group of eight points.
/// @param corner (c) -> Corner c @param sound lanes with valid domains
template <int Dim, class CornerOf>
void fill_corners(const Grid<Dim>& grid, const CornerOf& corner, const Mask& sound, StencilGroup<Dim>& group) {
  const Counts<Dim> strides = grid.strides();
  group.count = power(4, Dim);
  group.shape = {power(2, Dim - 1), 2};
  for (int r = 0; r < group.shape.rows; ++r) group.row[r] = (r & 1) * strides[1] + (r >> 1) * strides[Dim - 1];
  Reach reach{.lowest = Pack(grid.nodes[Dim - 1]), .highest = Pack(0.0), .inside = sound};
  for (int c = 0; c < power(2, Dim); ++c) add_corner<Dim>(grid, c, corner(c), group, reach);
  group.lowest = whole_numbers(reach.lowest);
  group.highest = whole_numbers(reach.highest);
  group.keep_lanes(reach.inside);
}

} // namespace riedel
