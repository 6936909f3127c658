/// The generalized vortex in a ring.
#pragma once

#include "apps/verify/manufactured.hpp"

namespace riedel {

/// @param cells across the ring
Manufactured<2> vortex(Index cells);
VerifyProblem vortex_problem();

} // namespace riedel
