/// All points of all bodies, eight at a time, with their stencils.
#pragma once

#include "core/base/parallel.hpp"
#include "core/step/kernels/gather.hpp"
#include "core/step/model.hpp"

namespace riedel {

/// Calls `visit(body, stencil, p)` for every eight points of a body, p the first of them. Blocks run in parallel.
template <int Dim, class Visit>
void for_each_group(State<Dim>& state, const Model<Dim>& model, Body<Dim>& body, const Visit& visit) {
  for_each_block(body.points.size(), [&](Range whole) {
    for (Index b = whole.begin; b < whole.end; b += stencil_block) {
      const Range block{b, std::min(b + stencil_block, whole.end)};
      const Stencils<Dim>& stencils = body.stencils.of(*model.scheme, state.grid, body.points, block, state.clock);
      for (Index p = b; p < block.end; p += pack_size) visit(body, stencils.group_of(p), p);
    }
  });
}

/// The same for all bodies.
template <int Dim, class Visit>
void for_each_group(State<Dim>& state, const Model<Dim>& model, const Visit& visit) {
  for (Body<Dim>& body : state.bodies) for_each_group(state, model, body, visit);
}

/// Calls `take(sum, body, p)` for every eight points of all bodies, with the values gathered from the grid.
template <Use use, int Dim, class Take>
void for_each_gathered(State<Dim>& state, const Model<Dim>& model, const Take& take) {
  for_each_group(state, model, [&](Body<Dim>& body, const StencilGroup<Dim>& stencil, Index p) {
    Gathered<Dim> sum;
    gather<use>(stencil, state.nodes.motion, sum);
    take(sum, body, p);
  });
}

} // namespace riedel
