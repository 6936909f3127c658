/// Measures of the shear band in a frame of a specimen, and their form in summary.json.
#pragma once

#include "core/analysis/stress_quality.hpp"
#include "core/io/frame.hpp"

#include <functional>
#include <nlohmann/json_fwd.hpp>

namespace riedel {

/// Maps a position in the frame's axes [m] to the specimen's axes; empty: they coincide.
using Placement = std::function<Vec<2>(const Vec<2>& place)>;

/// The shear band in a plane frame; found by the shear strain if the law has no void ratio.
ShearBand measure_band(const Frame& frame, const BandSettings& settings, const Placement& in_specimen = {});

/// Quality of the stresses within the band of a plane frame.
StressQuality measure_quality(const Frame& frame, const ShearBand& band, const QualitySettings& settings,
                              const Placement& in_specimen = {});

nlohmann::ordered_json band_json(const ShearBand& band);
nlohmann::ordered_json quality_json(const StressQuality& quality);

} // namespace riedel
