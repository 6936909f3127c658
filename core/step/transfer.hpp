/// Points to grid. Sums over points run slab by slab, see slab_order.hpp.
#pragma once

#include "core/step/model.hpp"

namespace riedel {

/// m_i = Σ_p N_ip m_p, (mv)_i = Σ_p N_ip m_p v_p, f_i = −Σ_p V_p (σ_p + p I) ∇N_ip, and the surface loads.
template <int Dim>
void points_to_grid(State<Dim>& state, const Model<Dim>& model);

/// m_i and (mv)_i alone, and the velocities v_i = (mv)_i/m_i.
template <int Dim>
void map_mass_and_momentum(State<Dim>& state, const Model<Dim>& model);

/// f_i alone, added to what stands there.
template <int Dim>
void map_forces(State<Dim>& state, const Model<Dim>& model);

/// v_i = (mv)_i/m_i + a_i Δt and a_i = f_i/m_i + g: gravity acts alike on all points, Σ_p N_ip m_p g = m_i g.
template <int Dim>
void advance_momentum(State<Dim>& state, const Model<Dim>& model, double dt);

/// v_i = (mv)_i/m_i, the accelerations as they are.
template <int Dim>
void divide_momentum(State<Dim>& state, const Model<Dim>& model);

} // namespace riedel
