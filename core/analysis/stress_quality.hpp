/// How sound the stresses inside a shear band are: docs/theory/stress_filter.md tells what unsound ones come from.
#pragma once

#include "core/analysis/shear_band.hpp"

#include <string>

namespace riedel {

/// What is known of the points of a specimen, one number each, in its own axes.
struct QualityFields {
  std::span<const double> x;          ///< [m]
  std::span<const double> y;          ///< [m]
  std::span<const double> pressure;   ///< p, compression positive [Pa]
  std::span<const double> void_ratio; ///< e [-]; empty: the law has none
  std::span<const double> rate;       ///< ‖D‖ [1/s]
};

struct QualitySettings {
  double core = 0.0;         ///< distance from the band's line up to which a point is in the core [m]
  double smoothing = 0.0;    ///< a of the weights exp(−(r/a)²) of a local mean over all points within `core` [m]
  double min_pressure = 0.0; ///< below which a point carries no stress to speak of [Pa]
};

/// Scatter about the local mean in the band's core, the outer fifths of the band's length left out; `no_figure` without
/// a band.
struct StressQuality {
  double pressure_scatter = no_figure;   ///< rms of p about its local mean, over the mean p of the core [-]
  double void_ratio_scatter = no_figure; ///< rms of e about its local mean [-]
  double rate_scatter = no_figure;       ///< rms of ‖D‖ about its local mean, over the mean of the core [-]
  std::size_t core_points = 0;
  std::size_t without_stress = 0; ///< of these, points below the least pressure

  /// What is to be doubted, in words; empty: nothing.
  [[nodiscard]] std::string doubt() const;
};

constexpr double doubtful_scatter = 0.1; ///< of p, from which on the stresses in the band are told to be unsound

[[nodiscard]] StressQuality measure_stress_quality(const QualityFields& fields, const ShearBand& band,
                                                   const QualitySettings& settings);

} // namespace riedel
