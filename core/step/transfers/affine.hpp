/// The affine transfers, APIC and TPIC: a point carries the slope of the velocity about it, so that its nodes get
/// v_p + C_p (x_i − x_p), and takes v_p = Σ_i N_ip v_i from them. They differ in what they keep of the slope: apic.hpp,
/// tpic.hpp.
#pragma once

#include "core/step/kernels/stencil_walk.hpp"
#include "core/step/model.hpp"

namespace riedel {

/// The first sums of a step: m_i = Σ_p N_ip m_p and (mv)_i = Σ_p N_ip m_p (v_p + C_p (x_i − x_p)), which are the
/// values; with both also f_i = −Σ_p V_p (σ_p + p I) ∇N_ip.
template <Use use, int Dim>
void affine_points_to_grid(State<Dim>& state, const Model<Dim>& model);

/// v_p = Σ_i N_ip v_i, its slope, and x_p += Δt v_p.
template <int Dim>
void affine_move_points(State<Dim>& state, const Model<Dim>& model, double dt);

/// The same, and the kinematics from the same velocities: USL.
template <int Dim>
void affine_grid_to_points(State<Dim>& state, const Model<Dim>& model, double dt);

/// v_p and its slope, and back to the momenta of the nodes: the M of MUSL. Points stay where they are.
template <int Dim>
void affine_remap_velocity(State<Dim>& state, const Model<Dim>& model, double dt);

} // namespace riedel
