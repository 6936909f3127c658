/// Axis-aligned displacement in a unit square or cube, a manufactured solution (Wallstedt & Guilkey 2008, J. Comput.
/// Phys. 227): u_a = A sin(2πX_a) sin(cπt + φ_a) along each axis a, c² = E/ρ, between rollers, neo-Hookean.
#pragma once

#include "apps/verify/manufactured.hpp"

namespace riedel {

/// φ = (0, π), so that the motion starts from the undeformed square.
/// @param cells along an edge
/// @param amplitude A [m]
Manufactured<2> axis_aligned_in_square(Index cells, double amplitude);

/// φ = (0, 2π/3, 4π/3): the motion starts from a deformed state.
Manufactured<3> axis_aligned_in_cube(Index cells, double amplitude);

} // namespace riedel
