/// Walls at given positions, as conditions on nodes.
#pragma once

#include "core/step/boundaries/prescribed_velocity.hpp"

namespace riedel {

/// The nodes on a wall and behind it.
/// @param axis normal to the wall @param place position along it, on a grid line [m]
/// @throws InputError, with the nearest grid lines, if there is no grid line at that position
template <int Dim>
NodeBox<Dim> side(const Grid<Dim>& grid, const std::string& name, int axis, double place, Behind behind);

/// A smooth wall: nodes on it or behind it do not move along its normal. Arguments as for `side`.
template <int Dim>
Boundary<Dim> smooth_wall(const Grid<Dim>& grid, std::string name, int axis, double place, Behind behind);

/// A rough wall: nodes on it or behind it do not move at all. One condition per axis, called `name`_x, `name`_y, …
template <int Dim>
std::vector<Boundary<Dim>> rough_wall(const Grid<Dim>& grid, const std::string& name, int axis, double place,
                                      Behind behind);

/// A wall with Coulomb friction: nodes on it or behind it do not move into it, and the tangential force is limited by
/// `coefficient` times the normal force. Material may separate from it. Arguments as for `side`.
/// @throws InputError, also for a negative coefficient
template <int Dim>
Boundary<Dim> friction_wall(const Grid<Dim>& grid, const std::string& name, int axis, double place, Behind behind,
                            double coefficient);

} // namespace riedel
