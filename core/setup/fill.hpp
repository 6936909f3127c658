/// Points and grids from positions in metres.
#pragma once

#include "core/step/state.hpp"

#include <string>

namespace riedel {

/// Whether a position belongs to a body.
template <int Dim>
using Shape = std::function<bool(const Vec<Dim>& place)>;

/// Points at the centres of adjacent boxes.
template <int Dim>
struct Lattice {
  Vec<Dim> corner = Vec<Dim>::Zero(); ///< of the first box [m]
  Vec<Dim> spacing;                   ///< size of a box [m]
  Counts<Dim> count;                  ///< boxes along each axis
};

/// The lattice with `per_cell` points along each axis of a cell, in a box of cells.
template <int Dim>
Lattice<Dim> lattice_of(Counts<Dim> cells, const Vec<Dim>& cell, Index per_cell,
                        const Vec<Dim>& corner = Vec<Dim>::Zero()) {
  for (Index& n : cells) n *= per_cell;
  return {.corner = corner, .spacing = cell / per_cell, .count = cells};
}

/// Puts points on the positions of a lattice inside the shape (on all positions without a shape), the first axis
/// fastest: position, half size, volume (per metre of depth in the plane) and initial volume. All else is zero.
/// @param states number of state columns that the points' law declares
template <int Dim>
void fill(Points<Dim>& points, const Lattice<Dim>& lattice, int states, const Shape<Dim>& holds = nullptr);

/// A grid with grid lines through the corners of a box, and `margin` layers of cells around it.
/// @throws InputError unless the box contains whole cells, to a millionth
template <int Dim>
Grid<Dim> grid_around(const Vec<Dim>& lower, const Vec<Dim>& upper, double cell, Index margin);

/// A body at rest and without stress: `per_cell` points along each axis in every cell of the grid, at the positions
/// inside the shape, with mass and state from its law.
/// @param state of every point, one number per column; empty: the law's initial state
/// @throws InputError if the shape contains no position, or the state does not have as many numbers as the law declares
template <int Dim>
Body<Dim> make_body(std::string name, std::shared_ptr<const Material> law, const Grid<Dim>& grid, Index per_cell,
                    const Shape<Dim>& holds, std::vector<double> state = {});

} // namespace riedel
