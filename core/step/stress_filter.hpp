/// Lets stresses and volumes in the null space of the grid decay. docs/theory/stress_filter.md gives the derivation and
/// the reasons for this form.
#pragma once

#include "core/step/model.hpp"

namespace riedel {

/// With r = (I − Q)(I − S)^m (I − Q) a, where S smooths by the scheme's weights (core/step/smoothing.hpp) and Q gives
/// the nearest linear field: σ_p ← σ_p − (1 − e^(−λ k Δt)) r_p with r of σ if the point carries stress; r of ln J gives
/// the addition to tr L until the next filtered step. In every k-th step, after the points are located.
template <int Dim>
void filter_stresses(State<Dim>& state, const Model<Dim>& model, double dt);

} // namespace riedel
