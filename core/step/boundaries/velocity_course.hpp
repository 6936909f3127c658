/// Velocity of a boundary over time.
#pragma once

#include "core/base/parameters.hpp"

#include <functional>

namespace riedel {

/// Velocity [m/s] as a function of time [s].
using VelocityCourse = std::function<double(double time)>;

/// @return speed ramped smoothly from zero to `speed` over `ramp_time`
VelocityCourse ramped(double speed, double ramp_time);

/// @return velocities interpolated linearly between the given times, and constant before the first and after the last
/// @throws InputError unless times are ascending and there is one velocity for each
VelocityCourse tabled(std::vector<double> times, std::vector<double> velocities);

/// `velocity`, `times` and `ramp_time`: a velocity that may be ramped, or a table.
Keys velocity_keys();

/// From the values of these keys. Throws InputError.
VelocityCourse velocity_course(const Values& values);

} // namespace riedel
