/// How fast a boundary moves, as time goes on.
#pragma once

#include "core/base/parameters.hpp"

#include <functional>

namespace riedel {

/// [m/s], by time [s]
using VelocityCourse = std::function<double(double time)>;

/// @return speed ramped smoothly from zero to `speed` over `ramp_time`
VelocityCourse ramped(double speed, double ramp_time);

/// @return velocities that are linear between the given times, and those of the first and the last outside
/// @throws InputError unless times rise and there is a velocity for each
VelocityCourse tabled(std::vector<double> times, std::vector<double> velocities);

/// `velocity`, `times` and `ramp_time`: a velocity that may be ramped, or a table.
Keys velocity_keys();

/// From the values of these keys. Throws InputError.
VelocityCourse velocity_course(const Values& values);

} // namespace riedel
