/// What a frame of a specimen tells of its shear band, and how summary.json says it.
#pragma once

#include "core/analysis/stress_quality.hpp"
#include "core/io/frame.hpp"

#include <functional>
#include <nlohmann/json_fwd.hpp>

namespace riedel {

/// A place in the frame's axes [m] to one in the specimen's; none: they are the same.
using Placement = std::function<Vec<2>(const Vec<2>& place)>;

/// The band of a frame in the plane, by the shear strain for a law without a void ratio.
ShearBand measure_band(const Frame& frame, const BandSettings& settings, const Placement& in_specimen = {});

/// How sound the stresses of a frame in the plane are within its band.
StressQuality measure_quality(const Frame& frame, const ShearBand& band, const QualitySettings& settings,
                              const Placement& in_specimen = {});

nlohmann::ordered_json band_json(const ShearBand& band);
nlohmann::ordered_json quality_json(const StressQuality& quality);

} // namespace riedel
