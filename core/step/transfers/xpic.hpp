/// The extended particle-in-cell transfer, XPIC(m): Hammerquist & Nairn (2017), Comput. Methods Appl. Mech. Engrg. 318,
/// 724–738.
#pragma once

#include "core/step/model.hpp"

namespace riedel {

/// v_p ← the velocities that are left of v_p when what the grid does not see is taken out: with S from grid to points
/// and S⁺ back, by mass, V ← (I − (I − S S⁺)ᵐ) V. FLIP's update of what is left is XPIC(m); m = 1 is PIC. Needs the
/// (mv)_i of the points' velocities, and uses them up. Does nothing for another transfer.
template <int Dim>
void filter_velocities(State<Dim>& state, const Model<Dim>& model);

} // namespace riedel
