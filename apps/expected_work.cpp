#include "apps/expected_work.hpp"

#include "apps/specimen_geometry.hpp"
#include "materials/element/law_point.hpp"

#include <cmath>
#include <numbers>

namespace riedel {

namespace {

/// A point's step without neighbours takes about as long as looking at so many of them.
constexpr double neighbours_of_a_step = 15.0 * 8.0;
constexpr double usual_wave_speed = 300.0; ///< of dense sand under load [m/s]
constexpr double usual_step = 1.2e-7;      ///< time of a point's step in the plane, docs/benchmarks.md [s]

double neighbours(const Values& v, double points) {
  const auto& cells = v.integers("grid.cells");
  const double per_direction = v.number("specimen.points_per_cell"), reach = 3.0 * v.number("nonlocal.length");
  const double area = v.number("specimen.width") * v.number("specimen.height") / static_cast<double>(cells[0]) /
                      static_cast<double>(cells[1]) / per_direction / per_direction;
  return std::min(std::numbers::pi * reach * reach / area, points);
}

} // namespace

double time_to(double distance, double speed, double ramp) {
  const double in_ramp = 0.5 * speed * ramp; // half of the speed on average
  return distance >= in_ramp ? ramp + (distance - in_ramp) / speed : ramp * std::pow(distance / in_ramp, 1.0 / 3.0);
}

double expected_points(const Values& v) {
  const auto& cells = v.integers("grid.cells");
  const double per_direction = v.number("specimen.points_per_cell");
  double points = static_cast<double>(cells[0]) * static_cast<double>(cells[1]) * per_direction * per_direction;
  if (dimensions_of_biaxial(v) == 3) points *= v.number("specimen.depth_cells") * per_direction;
  return points;
}

WaveSpeeds wave_speeds(const Values& v, const Material& law) {
  return wave_speeds(law, v.number("loading.confining_pressure"), v.number("specimen.void_ratio"));
}

WaveSpeeds wave_speeds(const Material& law, double pressure, double void_ratio) {
  constexpr double loaded = 10.0;
  LawPoint point{.state = law.initial_state()};
  for (std::size_t c = 0; c < 3; ++c) point.stress.m[c] = -pressure;
  if (const int e = state_column(law.states(), "void_ratio"); e >= 0)
    point.state[static_cast<std::size_t>(e)] = void_ratio;
  const auto speed = [&](double otherwise) {
    const double found = survey(law, point).wave_speed;
    return std::isfinite(found) && found > 0.0 ? found : otherwise;
  };
  const double at_start = speed(usual_wave_speed);
  point.stress.m[1] *= loaded;
  return {at_start, std::max(at_start, speed(at_start))};
}

ExpectedWork expected_work(const Values& v, const WaveSpeeds& speeds) {
  const auto& cells = v.integers("grid.cells");
  const double width = v.number("specimen.width"), height = v.number("specimen.height");
  ExpectedWork all{.points = expected_points(v)};
  const double cell = std::min(width / static_cast<double>(cells[0]), height / static_cast<double>(cells[1]));
  all.limit = cell / speeds.at_start;
  all.step = v.is_text("time.step") ? v.number("time.cfl") * cell / speeds.under_load : v.number("time.step");
  all.time =
      time_to(v.number("loading.final_strain") * height, v.number("loading.speed"), v.number("loading.ramp_time"));
  all.steps = all.time / all.step;
  const double slab = dimensions_of_biaxial(v) == 3 ? 3.0 : 1.0;
  all.work = all.points * all.steps * slab * (1.0 + neighbours(v, all.points) / neighbours_of_a_step);
  return all;
}

double ExpectedWork::seconds() const { return usual_step * work; }

std::string span_text(double seconds) {
  constexpr double minute = 60.0, hour = 60.0 * minute, day = 24.0 * hour, year = 365.0 * day;
  if (seconds < 2.0 * minute) return short_text(std::max(seconds, 1.0), 2) + " s";
  if (seconds < 2.0 * hour) return short_text(seconds / minute, 2) + " min";
  if (seconds < 2.0 * day) return short_text(seconds / hour, 2) + " h";
  return seconds < 2.0 * year ? short_text(seconds / day, 3) + " days" : short_text(seconds / year, 2) + " years";
}

} // namespace riedel
