/// The shear band of a frame of the biaxial test, measured with the settings of its case.
#pragma once

#include "apps/biaxial/case.hpp"
#include "core/analysis/frame_measures.hpp"
#include "core/base/parameters.hpp"

namespace riedel {

/// Measures the band of a plane frame with the case's l_c and threshold of the void ratio.
ShearBand measure_band(const Frame& frame, const BiaxialCase& values);

/// Quality of the stresses of a plane frame within its band. The core extends 2 l_c to either side, or 1.8 cells where
/// that is more or the law is local; local means extend to the neighbouring points, about a cell; a point below 2 % of
/// the confining pressure counts as stress-free.
StressQuality measure_quality(const Frame& frame, const ShearBand& band, const BiaxialCase& values);

} // namespace riedel
