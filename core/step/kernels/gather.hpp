/// The inner loop from grid to points: gathers over the nodes of eight points' stencils.
#pragma once

#include "core/step/kernels/stencil_walk.hpp"

namespace riedel {

/// A node's motion summed over the stencils of eight points.
template <int Dim>
struct Gathered {
  std::array<Transpose8x4, Dim == 2 ? 1 : 2> motion; ///< Σ_i N_ip (v_i, a_i), rows of NodeMotion::Record
  GradientRows<Dim> gradient;                        ///< Σ_i ∂N_ip/∂x_a v_i
};

/// The same for one point.
template <int Dim>
struct GatheredLane {
  typename NodeMotion<Dim>::Record motion{};
  std::array<VectorLanes<Dim>, Dim> gradient{};

  template <Use use, std::size_t Shape>
  [[gnu::always_inline]] void add(const PatchLane<Shape, Dim>& patch, const NodeMotion<Dim>* nodes) {
    patch.for_each_node(nodes, [&](int e, const NodeMotion<Dim>& node) {
      const auto record = NodeMotion<Dim>::Record::load(node.velocity.data());
      if constexpr (use != Use::gradients) motion += patch.value_of(e) * record;
      if constexpr (use != Use::weights)
        for (int a = 0; a < Dim; ++a) gradient[a] += patch.gradient_of(e, a) * first_half(record);
    });
  }
  template <Use use>
  [[gnu::always_inline]] void store(Index lane, Gathered<Dim>& all) const {
    if constexpr (use != Use::gradients) {
      if constexpr (Dim == 2) {
        motion.store(all.motion[0].row(lane));
      } else {
        first_half(motion).store(all.motion[0].row(lane));
        second_half(motion).store(all.motion[1].row(lane));
      }
    }
    if constexpr (use != Use::weights) {
      if constexpr (Dim == 2)
        joined(gradient[0], gradient[1]).store(all.gradient.rows[0].row(lane));
      else
        for (int a = 0; a < Dim; ++a) gradient[a].store(all.gradient.rows[a].row(lane));
    }
  }
};

/// Computes what `use` requests.
template <Use use, int Dim>
void gather(const StencilEntries<Dim>& stencil, const AlignedVector<NodeMotion<Dim>>& nodes, Gathered<Dim>& sum) {
  const StencilEntries<Dim> entries = stencil;
  with_shape(entries.shape, [&](auto shape) {
    PatchLane<shape, Dim> lane(entries, 0);
    for (Index k = 0; k < pack_size; ++k, lane.to_next_lane()) {
      GatheredLane<Dim> gathered;
      PatchLane<shape, Dim> patch = lane;
      for (int n = 0; n < entries.count; n += patch.entries, patch.to_next_patch())
        gathered.template add<use>(patch, nodes.data());
      gathered.template store<use>(k, sum);
    }
  });
}

} // namespace riedel
