/// Axis-aligned displacement in a unit square or cube, a manufactured solution (Wallstedt & Guilkey 2008, J. Comput.
/// Phys. 227): u_a = A sin(2πX_a) sin(cπt + φ_a) along each axis a, c² = E/ρ, between rollers, neo-Hookean.
#pragma once

#include "apps/verify/manufactured.hpp"

namespace riedel {

/// @param cells along an edge
/// @param amplitude A [m]
Manufactured<2> axis_aligned_in_square(Index cells, double amplitude);

} // namespace riedel
