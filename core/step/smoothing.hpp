/// The part of the points' fields that the nodes do not represent.
#pragma once

#include "core/step/model.hpp"

namespace riedel {

/// Fields that are smoothed together, one row per point: seven of them, and one number of working space.
using FieldRows = AlignedVector<ShortVector<8>>;

/// a_p ← ((I − S)^m a)_p for a body's `fields`, where S = N M⁻¹ Nᵀ V maps points to nodes and back by the scheme's
/// weights: (S a)_p = Σ_i N_ip/M_i Σ_q N_iq V_q a_q, M_i = Σ_q N_iq V_q. S is self-adjoint in Σ_p V_p a_p b_p,
/// preserves constants and has eigenvalues in [0, 1].
template <int Dim>
void subtract_smooth(State<Dim>& state, const Model<Dim>& model, Body<Dim>& body, int m);

/// Subtracts from each of a body's `fields` the linear field c_0 + c·x that is nearest to it in Σ_p V_p (…)².
template <int Dim>
void subtract_linear(State<Dim>& state, Body<Dim>& body);

} // namespace riedel
