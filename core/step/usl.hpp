#pragma once

#include "core/step/model.hpp"

namespace riedel {

/// One step, stress updated last from the velocities of the momentum balance (USL).
/// Sulsky, Chen & Schreyer (1994), Comput. Methods Appl. Mech. Engrg. 118, 179–196.
template <int Dim>
void usl_step(State<Dim>& state, const Model<Dim>& model, double dt);

} // namespace riedel
