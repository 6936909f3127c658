#pragma once

#include "core/step/model.hpp"

namespace riedel {

/// One step, stress updated last from re-mapped velocities (MUSL).
/// Sulsky, Zhou & Schreyer (1995), Comput. Phys. Commun. 87, 236–252.
template <int Dim>
void musl_step(State<Dim>& state, const Model<Dim>& model, double dt);

} // namespace riedel
