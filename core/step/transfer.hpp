/// Points to grid and back. Sums over points run slab by slab, see cell_order.hpp; everything else block by block.
#pragma once

#include "core/step/model.hpp"

namespace riedel {

/// m_i = Σ_p N_ip m_p, (mv)_i = Σ_p N_ip m_p v_p, f_i = Σ_p N_ip m_p b − Σ_p V_p (σ_p + p I) ∇N_ip.
template <int Dim>
void points_to_grid(State<Dim>& state, const Model<Dim>& model);

/// m_i and (mv)_i alone, and the velocities v_i = (mv)_i/m_i.
template <int Dim>
void map_mass_and_momentum(State<Dim>& state);

/// f_i alone, added to what stands there.
template <int Dim>
void map_forces(State<Dim>& state, const Model<Dim>& model);

/// v_i = ((mv)_i + f_i Δt)/m_i and a_i = f_i/m_i.
template <int Dim>
void advance_momentum(State<Dim>& state, double dt);

/// v_p = flip (v_p + Δt Σ N_ip a_i) + (1 − flip) Σ N_ip v_i, x_p += Δt Σ N_ip v_i.
template <int Dim>
void grid_to_points(State<Dim>& state, const Model<Dim>& model, double dt);

/// v_i = Σ_p N_ip m_p v_p/m_i with the points' new velocities: the M of MUSL.
template <int Dim>
void remap_velocity(State<Dim>& state);

} // namespace riedel
