/// Whether a specimen whose sides are loaded by points starts in equilibrium.
#pragma once

#include "apps/biaxial/case.hpp"
#include "core/interface/catalogue.hpp"

namespace riedel {

/// The largest force on a free node of the case's specimen, on few cells and without gravity, relative to the force of
/// the lateral pressure on a cell [-]. It depends on the scheme and the points per cell.
double imbalance_at_start(const BiaxialCase& values, const Catalogue& catalogue);

} // namespace riedel
