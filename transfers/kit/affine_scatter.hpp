/// The inner loop of the affine transfers from points to grid.
#pragma once

#include "core/step/kernels/scatter.hpp"
#include "transfers/kit/moments.hpp"

namespace riedel {

/// Contribution of eight points to a node: N times mass and momentum, and N (x_i − x_p)_a times m_p C_p e_a.
template <int Dim>
struct AffineShares {
  Transpose8x4 mass; ///< rows of NodeSums::MassRecord, like the others
  std::array<Transpose8x4, Dim> gradient;

  /// m_p C_p e_a
  void put_gradient(const Pack& m, const PackMatrix<Dim>& C) {
    for (int a = 0; a < Dim; ++a) {
      std::array<Pack, 4> columns;
      columns.fill(Pack(0.0));
      for (int i = 0; i < Dim; ++i) columns[i] = m * C[i][a];
      gradient[a].put(columns);
    }
  }
};

/// (mv)_i += N_ip m_p (v_p + C_p (x_i − x_p)) and m_i += N_ip m_p, for the lanes of a patch of first moments.
template <std::size_t Shape, int Dim>
[[gnu::always_inline]] inline void scatter_affine_patch(PatchLane<Shape, Dim> lane, Range lanes,
                                                        const AffineShares<Dim>& contributions, NodeSums<Dim>* nodes) {
  constexpr int entries = PatchLane<Shape, Dim>::entries;
  using MassRecord = typename NodeSums<Dim>::MassRecord;
  for (Index k = lanes.begin; k < lanes.end;) {
    const PatchLane<Shape, Dim> first = lane;
    std::array<MassRecord, entries> sum;
    first.for_each_node(nodes,
                        [&](int e, const NodeSums<Dim>& node) { sum[e] = MassRecord::load(node.momentum.data()); });
    do {
      const MassRecord of_mass = MassRecord::load(contributions.mass.row(k));
      std::array<MassRecord, Dim> of_gradient;
      for (int a = 0; a < Dim; ++a) of_gradient[a] = MassRecord::load(contributions.gradient[a].row(k));
      for (int e = 0; e < entries; ++e) {
        sum[e] += lane.value_of(e) * of_mass;
        for (int a = 0; a < Dim; ++a) sum[e] += lane.gradient_of(e, a) * of_gradient[a];
      }
      lane.to_next_lane();
    } while (++k < lanes.end && *lane.base == *first.base);
    first.for_each_node(nodes, [&](int e, NodeSums<Dim>& node) { sum[e].store(node.momentum.data()); });
  }
}

/// Adds the contributions of the lanes to the nodes.
template <int Dim>
void scatter_affine(const StencilEntries<Dim>& moments, Range lanes, const AffineShares<Dim>& contributions,
                    Nodes<Dim>& nodes) {
  const StencilEntries<Dim> stencil = moments;
  with_shape(stencil.shape, [&](auto shape) {
    PatchLane<shape, Dim> patch(stencil, lanes.begin);
    for (int n = 0; n < stencil.count; n += patch.entries, patch.to_next_patch())
      scatter_affine_patch(patch, lanes, contributions, nodes.sums.data());
  });
}

} // namespace riedel
