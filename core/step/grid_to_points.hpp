/// Strains of the points, and the part of their motion that is the same for all velocity transfers.
#pragma once

#include "core/step/model.hpp"

namespace riedel {

/// L_p = Σ_i v_i ⊗ ∇N_ip, F_p ← (I + L_p Δt) F_p, V_p = V_p0 det F_p, ‖D_p‖, and the accumulated shear strain.
template <int Dim>
void update_kinematics(State<Dim>& state, const Model<Dim>& model, double dt);

/// The same, followed by the motion x_p += Δt Σ N_ip v_i that the transfer's velocity remap has postponed.
template <int Dim>
void deform_and_move(State<Dim>& state, const Model<Dim>& model, double dt);

/// At the end of a step: moves what the scheme stores for each point.
template <int Dim>
void move_scheme_columns(State<Dim>& state, const Model<Dim>& model, double dt);

} // namespace riedel
