/// Travel time of a plate that starts smoothly.
#pragma once

namespace riedel {

/// Time for a plate, whose speed [m/s] rises smoothly over `ramp` [s], to cover a distance [m]. @return [s]
double time_to(double distance, double speed, double ramp);

} // namespace riedel
