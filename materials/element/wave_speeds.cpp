#include "materials/element/wave_speeds.hpp"

#include "materials/element/material_point.hpp"

namespace riedel {

namespace {
constexpr double usual_wave_speed = 300.0; ///< of dense sand under load [m/s]
} // namespace

WaveSpeeds wave_speeds(const Material& law, double pressure, double void_ratio) {
  constexpr double loaded = 10.0;
  MaterialPoint point{.state = law.initial_state()};
  for (std::size_t c = 0; c < 3; ++c) point.stress.m[c] = -pressure;
  if (const int e = state_column(law.states(), "void_ratio"); e >= 0)
    point.state[static_cast<std::size_t>(e)] = void_ratio;
  const auto speed = [&](double otherwise) {
    const double found = assess(law, point).wave_speed;
    return std::isfinite(found) && found > 0.0 ? found : otherwise;
  };
  const double at_start = speed(usual_wave_speed);
  point.stress.m[1] *= loaded;
  return {at_start, std::max(at_start, speed(at_start))};
}

} // namespace riedel
