#pragma once

#include "core/step/model.hpp"

namespace riedel {

/// One step, stress updated first from the velocities carried by the points (USF).
/// Bardenhagen (2002), J. Comput. Phys. 180, 383–403.
template <int Dim>
void usf_step(State<Dim>& state, const Model<Dim>& model, double dt);

} // namespace riedel
