/// Walls by their place, as conditions on nodes.
#pragma once

#include "core/step/boundaries/prescribed_velocity.hpp"

namespace riedel {

/// The nodes on a wall and behind it.
/// @param axis normal to the wall   @param place along it, on a line of the grid [m]
/// @throws InputError, with the lines beside it, if no line of the grid is there
template <int Dim>
NodeBox<Dim> side(const Grid<Dim>& grid, const std::string& name, int axis, double place, Behind behind);

/// A smooth wall: no node on it or behind it moves across. Arguments as for `side`.
template <int Dim>
Boundary<Dim> smooth_wall(const Grid<Dim>& grid, std::string name, int axis, double place, Behind behind);

/// A rough wall: no node on it or behind it moves at all. One condition for each axis, called `name`_x, `name`_y, …
template <int Dim>
std::vector<Boundary<Dim>> rough_wall(const Grid<Dim>& grid, const std::string& name, int axis, double place,
                                      Behind behind);

/// A wall with Coulomb friction: no node on it or behind it moves into it, and the tangential force is limited by
/// `coefficient` times the normal one. Material may leave it. Arguments as for `side`.
/// @throws InputError, also for a coefficient below 0
template <int Dim>
Boundary<Dim> friction_wall(const Grid<Dim>& grid, const std::string& name, int axis, double place, Behind behind,
                            double coefficient);

} // namespace riedel
