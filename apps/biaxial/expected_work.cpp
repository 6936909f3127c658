#include "apps/biaxial/expected_work.hpp"

#include "apps/biaxial/geometry.hpp"
#include "core/setup/ramp.hpp"

#include <cmath>
#include <numbers>

namespace riedel {

namespace {

/// A point's step without neighbours takes about as long as looking at so many of them.
constexpr double neighbours_of_a_step = 15.0 * 8.0;
constexpr double usual_step = 1.2e-7; ///< time of a point's step in the plane, docs/benchmarks.md [s]

double neighbours(const Values& v, double points) {
  const auto& cells = v.integers("grid.cells");
  const double per_direction = v.number("specimen.points_per_cell"), reach = 3.0 * v.number("nonlocal.length");
  const double area = v.number("specimen.width") * v.number("specimen.height") / static_cast<double>(cells[0]) /
                      static_cast<double>(cells[1]) / per_direction / per_direction;
  return std::min(std::numbers::pi * reach * reach / area, points);
}

} // namespace

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

} // namespace riedel
