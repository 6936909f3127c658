#include "core/step/locate.hpp"

#include "core/base/parallel.hpp"

namespace riedel {

namespace {

/// Whether no slab touches a row of nodes that another slab of its parity touches.
template <int Dim>
bool slabs_are_apart(const Body<Dim>& body) {
  std::array<Index, 2> highest{-1, -1}; // row touched so far, by parity
  for (Index s = 0; s < body.slabs.count(); ++s) {
    const Range points = body.slabs.range(s);
    Index low = std::numeric_limits<Index>::max(), high = -1;
    for (Index p = points.begin / pack_size * pack_size; p < points.end; p += pack_size) {
      const StencilGroup<Dim>& group = body.stencils.group_of(p);
      low = std::min(low, group.lowest_row);
      high = std::max(high, group.highest_row);
    }
    if (points.size() == 0) continue;
    if (low <= highest[s % 2]) return false;
    highest[s % 2] = std::max(highest[s % 2], high);
  }
  return true;
}

template <int Dim>
void evaluate(State<Dim>& state, const Model<Dim>& model, Body<Dim>& body) {
  for_each_block(body.points.size(),
                 [&](Range block) { model.scheme->evaluate(state.grid, body.points, block, body.stencils); });
}

template <int Dim>
void check_that_none_is_lost(const State<Dim>& state, const Body<Dim>& body) {
  for (Index p = 0; p < body.points.size(); ++p) {
    if (!body.stencils.group_of(p).lost[p % pack_size]) continue;
    std::string where;
    for (int a = 0; a < Dim; ++a) where += (a ? ", " : "") + exact_text(body.points.position[a][p]);
    throw RunError("point " + std::to_string(body.points.id[p]) + " of '" + body.name + "' left the grid at (" + where +
                   ") m, step " + std::to_string(state.step) + ", time " + exact_text(state.time) + " s");
  }
}

template <int Dim>
void sort_points(const State<Dim>& state, Body<Dim>& body, Index rows) {
  sort_by_cell(state.grid, rows, body.points, body.slabs, body.sort_space);
  if (body.averager) body.averager->forget_neighbours();
}

} // namespace

template <int Dim>
void locate_points(State<Dim>& state, const Model<Dim>& model) {
  for (Body<Dim>& body : state.bodies) {
    evaluate(state, model, body);
    check_that_none_is_lost(state, body);
    if (slabs_are_apart(body)) continue;
    sort_points(state, body, body.slabs.rows);
    evaluate(state, model, body);
    while (!slabs_are_apart(body)) { // supports wider than foreseen
      sort_points(state, body, 2 * body.slabs.rows);
      evaluate(state, model, body);
    }
  }
}

template <int Dim>
void prepare_points(State<Dim>& state, const Model<Dim>& model) {
  state.nodes.resize(state.grid.node_count());
  for (Body<Dim>& body : state.bodies) {
    body.stencils.resize(body.points.size(), model.scheme->max_nodes());
    // Thick enough for the support on both sides, for packs that straddle two slabs, and for points to drift by a row.
    sort_points(state, body, 6 + 2 * model.scheme->margin());
  }
  for (RigidBody<Dim>& body : state.rigid_bodies) body.stencils.resize(body.points.size(), model.scheme->max_nodes());
}

template void locate_points<2>(State<2>&, const Model<2>&);
template void locate_points<3>(State<3>&, const Model<3>&);
template void prepare_points<2>(State<2>&, const Model<2>&);
template void prepare_points<3>(State<3>&, const Model<3>&);

} // namespace riedel
