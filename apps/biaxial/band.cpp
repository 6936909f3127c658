#include "apps/biaxial/band.hpp"

#include "apps/biaxial/geometry.hpp"

namespace riedel {

namespace {

Placement placement(const Values& values) {
  return [turn = Turn(values)](const Vec<2>& place) { return turn.to_specimen(place); };
}

} // namespace

ShearBand measure_band(const Frame& frame, const Values& values) {
  return measure_band(
      frame, {.length = values.number("nonlocal.length"), .threshold = values.number("output.band_void_ratio")},
      placement(values));
}

StressQuality measure_quality(const Frame& frame, const ShearBand& band, const Values& values) {
  const auto& cells = values.integers("grid.cells");
  const double cell = std::max(values.number("specimen.width") / static_cast<double>(cells[0]),
                               values.number("specimen.height") / static_cast<double>(cells[1]));
  return measure_quality(frame, band,
                         {.core = std::max(2.0 * values.number("nonlocal.length"), 1.8 * cell),
                          .smoothing = 1.1 * cell,
                          .least_pressure = 0.02 * values.number("loading.confining_pressure")},
                         placement(values));
}

} // namespace riedel
