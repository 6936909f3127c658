/// Sums over points at nodes, in the same order for any number of threads and without locks: see
/// core/state/cell_order.hpp.
#pragma once

#include "core/base/parallel.hpp"
#include "core/step/locate.hpp"

namespace riedel {

/// Eight points and their stencils; `lanes` are those that belong to the slab.
template <int Dim>
struct SlabGroup {
  const StencilGroup<Dim>& stencil;
  Index first; ///< index of the point in lane 0
  Range lanes;
};

/// Whether every point of the group is on the grid and touches only rows of nodes that its slab may touch.
template <int Dim>
bool keeps_to(const SlabGroup<Dim>& group, Range rows) {
  bool answer = true;
  for (Index k = group.lanes.begin; k < group.lanes.end; ++k)
    answer = answer && !group.stencil.lost[k] && group.stencil.lowest[k] >= rows.begin &&
             group.stencil.highest[k] < rows.end;
  return answer;
}

/// Calls `add(group, space)` for all points of a body, slabs of even number first, then the odd ones; groups that leave
/// the rows of their slab are skipped. `space` is working space shared by the groups of a slab.
/// @return whether all points were added
template <class Space, int Dim, class Add>
bool add_in_slab_order(State<Dim>& state, const Model<Dim>& model, Body<Dim>& body, const Add& add) {
  const auto add_slab = [&](Index s) {
    const Range slab = body.slabs.range(s), rows = body.slabs.node_rows(s);
    bool all_kept = true;
    Space space;
    for (Index b = slab.begin / pack_size * pack_size; b < slab.end; b += stencil_block) {
      const Range block{b, std::min(b + stencil_block, slab.end)};
      const Stencils<Dim>& stencils = body.stencils.of(*model.scheme, state.grid, body.points, block, state.clock);
      for (Index p = b; p < block.end; p += pack_size) {
        const SlabGroup<Dim> group{
            stencils.group_of(p), p, {std::max(slab.begin - p, 0), std::min(slab.end - p, Index{pack_size})}};
        const bool kept = keeps_to(group, rows);
        if (kept) add(group, space);
        all_kept = all_kept && kept;
      }
    }
    body.slab_strays[s] = !all_kept;
  };
  body.slab_strays.resize(static_cast<std::size_t>(body.slabs.count()));
  for (Index parity = 0; parity < 2; ++parity)
    parallel_for_unequal((body.slabs.count() - parity + 1) / 2, [&](Index s) { add_slab(2 * s + parity); });
  return std::count(body.slab_strays.begin(), body.slab_strays.end(), 0) == body.slabs.count();
}

/// The first sums of a step, by `add_body(body)`, which returns whether all points were added: otherwise sorts the
/// points again and restarts.
template <int Dim, class AddBody>
void sum_from_zero(State<Dim>& state, const Model<Dim>& model, const AddBody& add_body) {
  const PhaseClock::Lap lap(state.clock, Phase::p2g);
  for (int attempt = 0;; ++attempt) {
    state.nodes.clear_sums();
    bool complete = true;
    for (Body<Dim>& body : state.bodies) complete = add_body(body) && complete;
    if (complete) return;
    sort_strays(state, model, attempt > 0);
  }
}

} // namespace riedel
