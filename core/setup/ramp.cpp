#include "core/setup/ramp.hpp"

#include <cmath>

namespace riedel {

double time_to(double distance, double speed, double ramp) {
  const double in_ramp = 0.5 * speed * ramp; // half the speed on average
  return distance >= in_ramp ? ramp + (distance - in_ramp) / speed : ramp * std::pow(distance / in_ramp, 1.0 / 3.0);
}

} // namespace riedel
