#include "core/step/boundaries/velocity_course.hpp"

#include "core/base/error.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace riedel {

VelocityCourse ramped(double speed, double ramp_time) {
  return [=](double t) {
    if (t >= ramp_time) return speed;
    return speed * 0.5 * (1.0 - std::cos(std::numbers::pi * std::max(t, 0.0) / ramp_time));
  };
}

VelocityCourse tabled(std::vector<double> times, std::vector<double> velocities) {
  if (times.empty() || times.size() != velocities.size())
    throw InputError("velocity has " + std::to_string(velocities.size()) + " entries, times " +
                     std::to_string(times.size()) + "; allowed: one velocity for each time");
  for (std::size_t i = 1; i < times.size(); ++i)
    if (!(times[i] > times[i - 1]))
      throw InputError("times: " + exact_text(times[i]) + " s follows " + exact_text(times[i - 1]) +
                       " s; allowed: ascending times");
  return [times = std::move(times), velocities = std::move(velocities)](double t) {
    const auto after = static_cast<std::size_t>(std::ranges::upper_bound(times, t) - times.begin());
    if (after == 0) return velocities.front();
    if (after == times.size()) return velocities.back();
    const double share = (t - times[after - 1]) / (times[after] - times[after - 1]);
    return velocities[after - 1] + share * (velocities[after] - velocities[after - 1]);
  };
}

Keys velocity_keys() {
  Keys keys{{"velocity", std::vector<double>{0.0}, "m/s", {}, "along the axis; one, or one for each of `times`"},
            {"times", std::vector<double>{}, "s", {}, "of the velocities, which are interpolated linearly"},
            {"ramp_time", 0.0, "s", at_least(0.0), "a single velocity is reached smoothly in this time"}};
  keys[0].any_length = keys[1].any_length = true;
  return keys;
}

VelocityCourse velocity_course(const Values& values) {
  const std::vector<double>&velocities = values.numbers("velocity"), &times = values.numbers("times");
  if (times.empty() && velocities.size() == 1) return ramped(velocities.front(), values.number("ramp_time"));
  if (values.number("ramp_time") > 0.0)
    throw InputError("ramp_time goes with a single velocity, not with a table of velocities");
  return tabled(times, velocities);
}

} // namespace riedel
