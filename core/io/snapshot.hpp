/// A simulation as a frame for files and pictures.
#pragma once

#include "core/io/frame.hpp"
#include "core/step/simulation.hpp"

namespace riedel {

/// Initial positions of the points of each body, then of each rigid body, by their ids [m].
template <int Dim>
using StartPlaces = std::vector<std::vector<Vec<Dim>>>;

/// Present positions of these points.
template <int Dim>
StartPlaces<Dim> places_of(const Simulation<Dim>& simulation);

/// The points of all bodies, one body after another and in the order of their ids, with all fields, the laws' state
/// variables under their own names, and the domains from the scheme. Values that a body's law does not have are NaN.
/// Boundary conditions that consist of points follow as further bodies, with a motion and a volume but no stress.
/// Polar rotation is the angle of R in F = R U, in 3-D of F's part in the plane x-y, positive counter-clockwise [deg].
/// @param start positions from which displacements are measured; without it there is no displacement
/// @param scalars of the frame as a whole, by name
template <int Dim>
Frame snapshot(const Simulation<Dim>& simulation, const StartPlaces<Dim>& start = {},
               std::map<std::string, double> scalars = {});

} // namespace riedel
