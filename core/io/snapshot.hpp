/// A simulation at one instant, as a frame for files and pictures.
#pragma once

#include "core/io/frame.hpp"
#include "core/step/simulation.hpp"

namespace riedel {

/// Points in the order of their ids, with every field, the law's state variables under their own names, and the domains
/// that the scheme gives them. Polar rotation is the angle of R in F = R U, in 3-D of F's part in the plane x-y,
/// positive counter-clockwise [deg].
template <int Dim>
Frame snapshot(const Simulation<Dim>& simulation, double u_over_h);

} // namespace riedel
