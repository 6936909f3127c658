#include "apps/biaxial/expected_work.hpp"

#include "apps/biaxial/geometry.hpp"
#include "core/setup/ramp.hpp"

#include <cmath>
#include <numbers>

namespace riedel {

namespace {

/// A step of a point without neighbours takes about as long as evaluating so many of them.
constexpr double neighbours_of_a_step = 15.0 * 8.0;
constexpr double usual_step = 1.2e-7; ///< time of a point's step in the plane, docs/benchmarks.md [s]

double neighbours(const BiaxialCase& v, double points) {
  const auto& cells = v.grid.cells;
  const double per_direction = static_cast<double>(v.specimen.points_per_cell), reach = 3.0 * v.nonlocal.length;
  const double area = v.specimen.width * v.specimen.height / static_cast<double>(cells[0]) /
                      static_cast<double>(cells[1]) / per_direction / per_direction;
  return std::min(std::numbers::pi * reach * reach / area, points);
}

} // namespace

double expected_points(const BiaxialCase& v) {
  const auto& cells = v.grid.cells;
  const double per_direction = static_cast<double>(v.specimen.points_per_cell);
  double points = static_cast<double>(cells[0]) * static_cast<double>(cells[1]) * per_direction * per_direction;
  if (v.grid.dimensions == 3) points *= static_cast<double>(v.specimen.depth_cells) * per_direction;
  return points;
}

WaveSpeeds wave_speeds(const BiaxialCase& v, const Material& law) {
  return wave_speeds(law, v.loading.confining_pressure, v.specimen.void_ratio);
}

ExpectedWork expected_work(const BiaxialCase& v, const WaveSpeeds& speeds) {
  const auto& cells = v.grid.cells;
  const double width = v.specimen.width, height = v.specimen.height;
  ExpectedWork all{.points = expected_points(v)};
  const double cell = std::min(width / static_cast<double>(cells[0]), height / static_cast<double>(cells[1]));
  all.limit = cell / speeds.at_start;
  all.step =
      v.keys.is_text("time.step") ? v.keys.number("time.cfl") * cell / speeds.under_load : v.keys.number("time.step");
  all.time = time_to(v.loading.final_strain * height, v.loading.speed, v.loading.ramp_time);
  all.steps = all.time / all.step;
  const double slab = v.grid.dimensions == 3 ? 3.0 : 1.0;
  all.work = all.points * all.steps * slab * (1.0 + neighbours(v, all.points) / neighbours_of_a_step);
  return all;
}

double ExpectedWork::seconds() const { return usual_step * work; }

} // namespace riedel
