/// How the material deforms around each point.
#pragma once

#include "core/step/model.hpp"

namespace riedel {

/// L_p = Σ_i v_i ⊗ ∇N_ip, F_p ← (I + L_p Δt) F_p, V_p = V_p0 det F_p, ‖D_p‖, and the accumulated shear strain.
template <int Dim>
void update_kinematics(State<Dim>& state, double dt);

} // namespace riedel
