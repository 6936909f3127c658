/// Boxes of nodes.
#pragma once

#include "core/interface/boundary_condition.hpp"

namespace riedel {

/// Whether a node lies in the box with these corners.
template <int Dim>
bool within_box(const Counts<Dim>& index, const Counts<Dim>& first, const Counts<Dim>& last) {
  bool inside = true;
  for (int a = 0; a < Dim; ++a) inside = inside && index[a] >= first[a] && index[a] <= last[a];
  return inside;
}

/// Numbers of the nodes in a box, ascending.
template <int Dim>
std::vector<Index> nodes_in(const Grid<Dim>& grid, const NodeBox<Dim>& box);

/// The wall formed by a box that reaches from side to side and, across its axis, from a row of nodes to the grid's end.
template <int Dim>
std::array<Walls, Dim> walls_of(const Grid<Dim>& grid, const NodeBox<Dim>& box);

} // namespace riedel
