/// Stresses and volumes that the nodes do not see fade: the null space of MPM's stresses. The derivation, and why it is
/// done this way, stands in docs/theory/stress_filter.md.
#pragma once

#include "core/step/model.hpp"

namespace riedel {

/// With r = (I − Q)(I − S)^m (I − Q) a, where S smooths by the scheme's weights (core/step/smoothing.hpp) and Q gives
/// the nearest linear field: σ_p ← σ_p − (1 − e^(−λ k Δt)) r_p of σ where the point carries stress, and from r of ln J
/// what is added to tr L from this step to the next that filters. In every k-th step, once the points are on the grid.
template <int Dim>
void filter_stresses(State<Dim>& state, const Model<Dim>& model, double dt);

} // namespace riedel
