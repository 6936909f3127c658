/// Rest by stopping motion again and again.
#pragma once

#include "core/run/run.hpp"

namespace riedel {

/// Stops the motion whenever its energy has begun to fall: what is left comes to rest in a share of the time that
/// damping takes.
/// @param run of the simulation, for so many steps
/// @return kinetic energy at the end over the greatest one [-]
double relax(Simulation<2>& simulation, Index steps, Run<2> run);

} // namespace riedel
