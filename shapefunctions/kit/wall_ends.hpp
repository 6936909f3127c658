/// For schemes whose functions end at walls.
#pragma once

#include "core/base/pack.hpp"
#include "core/state/grid.hpp"

namespace riedel {

/// Positions along one axis; a point on a wall is moved to this side of it by an insignificant amount, and one behind
/// it becomes invalid.
template <int Dim>
Pack before_walls(const Grid<Dim>& grid, int axis, const Pack& x) {
  constexpr double on_wall = 1e-11, slack_in_cells = 1e-6;
  const Walls& walls = grid.walls[axis];
  const double h = grid.cell[axis], slack = slack_in_cells * h;
  Pack place = x;
  Mask between = x <= x; // false for NaN
  if (walls.first != Walls::none_below) {
    const double wall = grid.origin[axis] + walls.first * h;
    between = between && x >= Pack(wall - slack);
    place = max(place, Pack(wall + on_wall * h));
  }
  if (walls.last != Walls::none_above) {
    const double wall = grid.origin[axis] + walls.last * h;
    between = between && x <= Pack(wall + slack);
    place = min(place, Pack(wall - on_wall * h));
  }
  return select(between, place, Pack(std::nan("")));
}

} // namespace riedel
