/// Whether the law admits the void ratios that a random field gives to the points.
#pragma once

#include "apps/biaxial/case.hpp"
#include "core/case/checked_case.hpp"
#include "core/interface/catalogue.hpp"

namespace riedel {

/// Refuses a field that gives a point a void ratio out of the law's limits, and names such a point. A field that is
/// smooth between the points is sampled more coarsely, and near the limits at every point; if there are too many points
/// to check, at evenly spaced ones, with a warning.
void check_random_field(const BiaxialCase& values, const Catalogue& catalogue, Diagnostics& found);

} // namespace riedel
