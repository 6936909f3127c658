/// Does the law admit what a random field of void ratios gives to the points?
#pragma once

#include "apps/biaxial/case.hpp"
#include "core/case/checked_case.hpp"
#include "core/interface/catalogue.hpp"

namespace riedel {

/// Refuses a field that gives a point a void ratio out of the law's limits, and names one. A field that is smooth
/// between the points is looked at more coarsely than they stand, and near the limits at every point; of points that
/// are too many to look at, evenly spread ones, with a warning.
void check_random_field(const BiaxialCase& values, const Catalogue& catalogue, Diagnostics& found);

} // namespace riedel
