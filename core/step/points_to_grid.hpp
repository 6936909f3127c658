/// Nodal forces and the momentum balance, the same for all velocity transfers. Sums over points: see slab_order.hpp.
#pragma once

#include "core/step/model.hpp"

namespace riedel {

/// f_i += −Σ_p V_p (σ_p + p I) ∇N_ip.
template <int Dim>
void map_forces(State<Dim>& state, const Model<Dim>& model);

/// v_i = (mv)_i/m_i + a_i Δt and a_i = f_i/m_i + g: gravity is the same for all points, Σ_p N_ip m_p g = m_i g.
template <int Dim>
void advance_momentum(State<Dim>& state, const Model<Dim>& model, double dt);

/// v_i = (mv)_i/m_i; accelerations are unchanged.
template <int Dim>
void divide_momentum(State<Dim>& state, const Model<Dim>& model);

} // namespace riedel
