/// The shear band of a frame, as summary.json tells it.
#pragma once

#include "apps/stress_quality.hpp"
#include "core/base/parameters.hpp"
#include "core/io/frame.hpp"

#include <nlohmann/json_fwd.hpp>

namespace riedel {

/// Measures the band of a frame in the plane with the case's l_c and void ratio of the threshold, and by the
/// shear strain for a law without a void ratio.
ShearBand measure_band(const Frame& frame, const Values& values);

nlohmann::ordered_json band_json(const ShearBand& band);

/// How sound the stresses of a frame in the plane are within its band: the core reaches 2 l_c to either side, or 1.8
/// cells where that is more or the law is local; local means reach as far as neighbouring points do, about a cell; a
/// point below 2 % of the confining pressure carries no stress.
StressQuality measure_quality(const Frame& frame, const ShearBand& band, const Values& values);

nlohmann::ordered_json quality_json(const StressQuality& quality);

} // namespace riedel
