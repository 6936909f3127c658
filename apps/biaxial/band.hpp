/// The shear band of a frame of the biaxial test, measured as its case says.
#pragma once

#include "apps/biaxial/case.hpp"
#include "core/analysis/frame_measures.hpp"
#include "core/base/parameters.hpp"

namespace riedel {

/// Measures the band of a frame in the plane with the case's l_c and void ratio of the threshold.
ShearBand measure_band(const Frame& frame, const BiaxialCase& values);

/// How sound the stresses of a frame in the plane are within its band: the core reaches 2 l_c to either side, or 1.8
/// cells where that is more or the law is local; local means reach as far as neighbouring points do, about a cell; a
/// point below 2 % of the confining pressure carries no stress.
StressQuality measure_quality(const Frame& frame, const ShearBand& band, const BiaxialCase& values);

} // namespace riedel
