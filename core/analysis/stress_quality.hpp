/// Quality of the stresses inside a shear band; docs/theory/stress_filter.md describes the causes of poor stresses.
#pragma once

#include "core/analysis/shear_band.hpp"

#include <string>

namespace riedel {

/// Fields of a specimen's points, one number per point, in the specimen's axes.
struct QualityFields {
  std::span<const double> x;          ///< [m]
  std::span<const double> y;          ///< [m]
  std::span<const double> pressure;   ///< p, compression positive [Pa]
  std::span<const double> void_ratio; ///< e [-]; empty: the law has none
  std::span<const double> rate;       ///< ‖D‖ [1/s]
};

struct QualitySettings {
  double core = 0.0;         ///< largest distance of a core point from the band's line [m]
  double smoothing = 0.0;    ///< a of the weights exp(−(r/a)²) of a local mean over all points within `core` [m]
  double min_pressure = 0.0; ///< below which a point counts as stress-free [Pa]
};

/// Scatter about the local mean in the band's core, without the outer fifths of the band's length; `no_figure` without
/// a band.
struct StressQuality {
  double pressure_scatter = no_figure;   ///< rms of p about its local mean, over the mean p of the core [-]
  double void_ratio_scatter = no_figure; ///< rms of e about its local mean [-]
  double rate_scatter = no_figure;       ///< rms of ‖D‖ about its local mean, over the mean of the core [-]
  std::size_t core_points = 0;
  std::size_t without_stress = 0; ///< core points below the minimum pressure

  /// What is doubtful, in words; empty: nothing.
  [[nodiscard]] std::string doubt() const;
};

constexpr double doubtful_scatter = 0.1; ///< of p, above which the stresses in the band are reported as doubtful

[[nodiscard]] StressQuality measure_stress_quality(const QualityFields& fields, const ShearBand& band,
                                                   const QualitySettings& settings);

} // namespace riedel
