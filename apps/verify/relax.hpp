/// Rest by stopping motion again and again.
#pragma once

#include "core/step/simulation.hpp"

namespace riedel {

/// Stops the motion whenever its energy has begun to fall: what is left comes to rest in a share of the time that
/// damping takes.
/// @param step takes one step of the simulation
/// @return kinetic energy at the end over the greatest one [-]
double relax(Simulation<2>& simulation, Index steps, const std::function<void()>& step);

} // namespace riedel
