/// A simulation as a frame for files and pictures.
#pragma once

#include "core/io/frame.hpp"
#include "core/step/simulation.hpp"

namespace riedel {

/// Where the points of each body, and of each rigid body after them, were at the start, by their ids [m].
template <int Dim>
using StartPlaces = std::vector<std::vector<Vec<Dim>>>;

/// Where these points are now.
template <int Dim>
StartPlaces<Dim> places_of(const Simulation<Dim>& simulation);

/// Every body's points, one body after the other and in the order of their ids, with every field, the laws' state
/// variables under their own names, and the domains that the scheme gives them. What a body's law does not have is not
/// a number there. Boundary conditions that consist of points follow as further bodies, which have a motion and a
/// volume but no stress. Polar rotation is the angle of R in F = R U, in 3-D of F's part in the plane x-y, positive
/// counter-clockwise [deg].
/// @param start from which points are displaced; without it there is no displacement
/// @param scalars of the frame as a whole, by name
template <int Dim>
Frame snapshot(const Simulation<Dim>& simulation, const StartPlaces<Dim>& start = {},
               std::map<std::string, double> scalars = {});

} // namespace riedel
