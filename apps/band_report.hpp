/// The shear band of a frame, as summary.json tells it.
#pragma once

#include "apps/shear_band.hpp"
#include "core/base/parameters.hpp"
#include "core/io/frame.hpp"

#include <nlohmann/json_fwd.hpp>

namespace riedel {

/// Measures the band of a frame in the plane with the case's l_c and void ratio of the threshold, and by the
/// shear strain for a law without a void ratio.
ShearBand measure_band(const Frame& frame, const Values& values);

nlohmann::ordered_json band_json(const ShearBand& band);

} // namespace riedel
