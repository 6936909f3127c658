/// Walls by their place, as conditions on nodes.
#pragma once

#include "core/step/boundary.hpp"

namespace riedel {

/// On which side of a wall there is no material.
enum class Behind { lower, upper };

/// A smooth wall: no node on it or behind it moves across.
/// @param axis normal to the wall   @param place along it, on a line of the grid [m]
/// @throws InputError, with the lines beside it, if no line of the grid is there
template <int Dim>
NodeCondition<Dim> smooth_wall(const Grid<Dim>& grid, std::string name, int axis, double place, Behind behind);

/// A rough wall: no node on it or behind it moves at all. One condition for each axis, called `name`_x, `name`_y, …
template <int Dim>
std::vector<NodeCondition<Dim>> rough_wall(const Grid<Dim>& grid, const std::string& name, int axis, double place,
                                           Behind behind);

} // namespace riedel
