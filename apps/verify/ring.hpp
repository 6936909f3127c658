/// The expanding ring.
#pragma once

#include "apps/verify/manufactured.hpp"

namespace riedel {

/// @param cells across the ring
Manufactured<2> ring(Index cells);
VerifyProblem ring_problem();

} // namespace riedel
