/// How long a plate that starts smoothly takes.
#pragma once

namespace riedel {

/// Until a plate, which rises to its speed [m/s] smoothly over `ramp` [s], has come so far [m]. @return [s]
double time_to(double distance, double speed, double ramp);

} // namespace riedel
