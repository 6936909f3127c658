/// Forces on the grid and its momentum balance, alike for all transfers of velocities. Sums over points run slab by
/// slab, see slab_order.hpp.
#pragma once

#include "core/step/model.hpp"

namespace riedel {

/// f_i = −Σ_p V_p (σ_p + p I) ∇N_ip, added to what stands there.
template <int Dim>
void map_forces(State<Dim>& state, const Model<Dim>& model);

/// v_i = (mv)_i/m_i + a_i Δt and a_i = f_i/m_i + g: gravity acts alike on all points, Σ_p N_ip m_p g = m_i g.
template <int Dim>
void advance_momentum(State<Dim>& state, const Model<Dim>& model, double dt);

/// v_i = (mv)_i/m_i, the accelerations as they are.
template <int Dim>
void divide_momentum(State<Dim>& state, const Model<Dim>& model);

} // namespace riedel
