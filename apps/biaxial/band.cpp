#include "apps/biaxial/band.hpp"

#include "apps/biaxial/geometry.hpp"

namespace riedel {

namespace {

Placement placement(const BiaxialCase& values) {
  return [turn = Turn(values)](const Vec<2>& place) { return turn.to_specimen(place); };
}

} // namespace

ShearBand measure_band(const Frame& frame, const BiaxialCase& values) {
  return measure_band(frame, {.length = values.nonlocal.length, .threshold = values.output.band_void_ratio},
                      placement(values));
}

StressQuality measure_quality(const Frame& frame, const ShearBand& band, const BiaxialCase& values) {
  const auto& cells = values.grid.cells;
  const double cell = std::max(values.specimen.width / static_cast<double>(cells[0]),
                               values.specimen.height / static_cast<double>(cells[1]));
  return measure_quality(frame, band,
                         {.core = std::max(2.0 * values.nonlocal.length, 1.8 * cell),
                          .smoothing = 1.1 * cell,
                          .min_pressure = 0.02 * values.loading.confining_pressure},
                         placement(values));
}

} // namespace riedel
