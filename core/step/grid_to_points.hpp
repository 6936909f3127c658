/// Grid to points: velocities, positions and strains, in the portions that the three orders of a step take.
#pragma once

#include "core/step/model.hpp"

namespace riedel {

/// v_p = flip (v_p + Δt Σ N_ip a_i) + (1 − flip) Σ N_ip v_i and x_p += Δt Σ N_ip v_i.
template <int Dim>
void move_points(State<Dim>& state, const Model<Dim>& model, double dt);

/// L_p = Σ_i v_i ⊗ ∇N_ip, F_p ← (I + L_p Δt) F_p, V_p = V_p0 det F_p, ‖D_p‖, and the accumulated shear strain.
template <int Dim>
void update_kinematics(State<Dim>& state, const Model<Dim>& model, double dt);

/// Both at once, from the same stencils and velocities: USL.
template <int Dim>
void grid_to_points(State<Dim>& state, const Model<Dim>& model, double dt);

/// v_p as in `move_points`, but the points stay where they are; and back, (mv)_i = Σ_p N_ip m_p v_p and v_i =
/// (mv)_i/m_i with the new v_p: the M of MUSL.
template <int Dim>
void remap_velocity(State<Dim>& state, const Model<Dim>& model, double dt);

/// `update_kinematics`, then the move that `remap_velocity` put off.
template <int Dim>
void deform_and_move(State<Dim>& state, const Model<Dim>& model, double dt);

/// At the end of a step: what the scheme keeps for each point takes part in the motion.
template <int Dim>
void move_scheme_columns(State<Dim>& state, const Model<Dim>& model, double dt);

} // namespace riedel
