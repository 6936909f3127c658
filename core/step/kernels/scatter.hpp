/// The inner loop from points to grid: from eight points to the nodes of their stencils.
#pragma once

#include "core/step/kernels/stencil_walk.hpp"
#include "core/step/slab_order.hpp"

namespace riedel {

/// Contribution of each of eight points to a node: N times its mass and momentum, and ∂N/∂x_a times a force.
template <int Dim>
struct PointContributions {
  Transpose8x4 mass; ///< rows of NodeSums::MassRecord
  GradientRows<Dim> force;
};

/// m_i += N_ip m_p, (mv)_i += N_ip (mv)_p, f_i += Σ_a ∂N_ip/∂x_a f_pa, or some of these, for the lanes of a patch.
/// Lanes in a row that touch the same nodes are summed before anything is written.
template <Use use, std::size_t Shape, int Dim>
[[gnu::always_inline]] inline void scatter_patch(PatchLane<Shape, Dim> lane, Range lanes,
                                                 const PointContributions<Dim>& contributions, NodeSums<Dim>* nodes) {
  constexpr int entries = PatchLane<Shape, Dim>::entries;
  using MassRecord = typename NodeSums<Dim>::MassRecord;
  using ForceRecord = typename NodeSums<Dim>::ForceRecord;
  for (Index k = lanes.begin; k < lanes.end;) {
    const PatchLane<Shape, Dim> first = lane;
    std::array<MassRecord, entries> mass;
    std::array<ForceRecord, entries> force;
    first.for_each_node(nodes, [&](int e, const NodeSums<Dim>& node) {
      if constexpr (use != Use::gradients) mass[e] = MassRecord::load(node.momentum.data());
      if constexpr (use != Use::weights) force[e] = ForceRecord::load(node.force.data());
    });
    do {
      const MassRecord of_mass = MassRecord::load(contributions.mass.row(k));
      std::array<ForceRecord, Dim> of_force;
      for (int a = 0; a < Dim; ++a) of_force[a] = ForceRecord::load(contributions.force.of(a, k));
      for (int e = 0; e < entries; ++e) {
        if constexpr (use != Use::gradients) mass[e] += lane.value_of(e) * of_mass;
        if constexpr (use != Use::weights)
          for (int a = 0; a < Dim; ++a) force[e] += lane.gradient_of(e, a) * of_force[a];
      }
      lane.to_next_lane();
    } while (++k < lanes.end && *lane.base == *first.base);
    first.for_each_node(nodes, [&](int e, NodeSums<Dim>& node) {
      if constexpr (use != Use::gradients) mass[e].store(node.momentum.data());
      if constexpr (use != Use::weights) force[e].store(node.force.data());
    });
  }
}

/// Adds the contributions of the group's lanes to the nodes.
template <Use use, int Dim>
void scatter(const SlabGroup<Dim>& group, const PointContributions<Dim>& contributions, Nodes<Dim>& nodes) {
  const StencilEntries<Dim> stencil = group.stencil;
  with_shape(stencil.shape, [&](auto shape) {
    PatchLane<shape, Dim> patch(stencil, group.lanes.begin);
    for (int n = 0; n < stencil.count; n += patch.entries, patch.to_next_patch())
      scatter_patch<use>(patch, group.lanes, contributions, nodes.sums.data());
  });
}

} // namespace riedel
