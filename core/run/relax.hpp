/// Brings a simulation to rest by repeatedly stopping the motion (kinetic damping).
#pragma once

#include "core/run/run.hpp"

namespace riedel {

/// Stops the motion whenever its kinetic energy begins to fall: it comes to rest much faster than by damping.
/// @param run of the simulation, for the given number of steps
/// @return kinetic energy at the end over its maximum [-]
double relax(Simulation<2>& simulation, Index steps, Run<2> run);

} // namespace riedel
