#include "core/step/locate.hpp"

#include <optional>

namespace riedel {

namespace {

constexpr std::int64_t steps_between_looks = 100; // in that time points cross a small part of a cell
constexpr Index one_in = 20;                      // one point in this many may be out of order

/// The first point whose support leaves the grid, if any.
template <int Dim>
std::optional<Index> first_lost(State<Dim>& state, const Model<Dim>& model, Body<Dim>& body) {
  const Points<Dim>& points = body.points;
  for (Index b = 0; b < points.size(); b += stencil_block) {
    const Range block{b, std::min(b + stencil_block, points.size())};
    const Stencils<Dim>& stencils = body.stencils.of(*model.scheme, state.grid, points, block, state.clock);
    for (Index p = b; p < block.end; ++p)
      if (stencils.group_of(p).lost[p % pack_size]) return p;
  }
  return std::nullopt;
}

template <int Dim>
std::string coordinates(const Vec<Dim>& x) {
  std::string text;
  for (int a = 0; a < Dim; ++a) text += (a ? ", " : "(") + exact_text(x[a]);
  return text + ") m";
}

template <int Dim>
void throw_if_lost(State<Dim>& state, const Model<Dim>& model, Body<Dim>& body) {
  const std::optional<Index> p = first_lost(state, model, body);
  if (!p) return;
  const char* const otherwise = model.scheme->point_data_size() > 0 ? ", or its domain has turned inside out" : "";
  throw RunError("point " + std::to_string(body.points.id[static_cast<std::size_t>(*p)]) + " of '" + body.name +
                 "' left the grid at " + coordinates(body.points.position_of(*p)) + ", step " +
                 std::to_string(state.step) + ", time " + exact_text(state.time) + " s" + otherwise);
}

template <int Dim>
void sort_points(State<Dim>& state, Body<Dim>& body, Index rows) {
  const PhaseClock::Lap lap(state.clock, Phase::sorting);
  sort_by_cell(state.grid, rows, body.points, body.slabs, body.sort_space);
  if (body.averager) body.averager->invalidate();
}

} // namespace

template <int Dim>
void prepare_points(State<Dim>& state, const Model<Dim>& model) {
  state.nodes.resize(state.grid.node_count());
  state.transfer_room.nodes.assign(static_cast<std::size_t>(model.transfer->node_records()),
                                   AlignedVector<NodeMotion<Dim>>(state.nodes.motion.size()));
  for (Body<Dim>& body : state.bodies) {
    initialise(*model.scheme, state.grid, body.points);
    body.stencils.resize(body.points.size(), model.scheme->max_nodes(), model.keep_stencils);
    body.displacement_increment.resize(body.points.size());
    if (model.stress_filter.on()) {
      state.nodes.smoothing.resize(state.nodes.size());
      if (body.points.expansion.components() == 0) {
        body.points.expansion = Columns(1);
        body.points.expansion.resize(body.points.size());
      }
      body.fields.assign(static_cast<std::size_t>(blocks_of(body.points.size()) * block_size), ShortVector<8>(0.0));
    }
    Columns& transfer_data = body.points.transfer_data;
    if (transfer_data.components() != model.transfer->point_data_size()) {
      transfer_data = Columns(model.transfer->point_data_size());
      transfer_data.resize(body.points.size());
    }
    // Thick enough for the support on both sides and for a drift of points by two rows.
    sort_points(state, body, 6 + 2 * model.scheme->margin());
  }
}

template <int Dim>
void locate_points(State<Dim>& state, const Model<Dim>& model) {
  while (state.transfer_room.threads.size() < static_cast<std::size_t>(max_threads()))
    state.transfer_room.threads.emplace_back(
        static_cast<std::size_t>(model.transfer->thread_data_size(model.scheme->max_nodes())));
  for (Body<Dim>& body : state.bodies) {
    if (state.step % steps_between_looks == 0) {
      const PhaseClock::Lap lap(state.clock, Phase::sorting);
      if (out_of_order(state.grid, body.points, body.sort_space) * one_in > body.points.size())
        sort_points(state, body, body.slabs.rows);
    }
    body.stencils.begin_step(*model.scheme, state.grid, body.points, state.clock);
  }
}

template <int Dim>
void check_inside(State<Dim>& state, const Model<Dim>& model) {
  Counts<Dim> last = state.grid.nodes;
  for (Index& n : last) --n;
  for (Body<Dim>& body : state.bodies)
    if (const std::optional<Index> p = first_lost(state, model, body))
      throw InputError(
          "body '" + body.name + "': point " + std::to_string(body.points.id[static_cast<std::size_t>(*p)]) + " at " +
          coordinates(body.points.position_of(*p)) +
          ", or its support in the scheme, lies outside the grid, which reaches from " +
          coordinates(state.grid.position({})) + " to " + coordinates(state.grid.position(last)) +
          "; allowed: positions with " + std::to_string(model.scheme->margin()) + " rows of nodes around their cell");
}

template <int Dim>
void keep_stencils(State<Dim>& state, const Model<Dim>& model) {
  for (Body<Dim>& body : state.bodies) {
    if (body.stencils.keeps()) continue;
    body.stencils.resize(body.points.size(), model.scheme->max_nodes(), true);
    body.stencils.begin_step(*model.scheme, state.grid, body.points, state.clock);
  }
}

template <int Dim>
void sort_strays(State<Dim>& state, const Model<Dim>& model, bool thicker) {
  for (Body<Dim>& body : state.bodies) {
    throw_if_lost(state, model, body);
    sort_points(state, body, thicker ? 2 * body.slabs.rows : body.slabs.rows);
    body.stencils.begin_step(*model.scheme, state.grid, body.points, state.clock);
  }
}

template void prepare_points<2>(State<2>&, const Model<2>&);
template void prepare_points<3>(State<3>&, const Model<3>&);
template void locate_points<2>(State<2>&, const Model<2>&);
template void locate_points<3>(State<3>&, const Model<3>&);
template void check_inside<2>(State<2>&, const Model<2>&);
template void check_inside<3>(State<3>&, const Model<3>&);
template void keep_stencils<2>(State<2>&, const Model<2>&);
template void keep_stencils<3>(State<3>&, const Model<3>&);
template void sort_strays<2>(State<2>&, const Model<2>&, bool);
template void sort_strays<3>(State<3>&, const Model<3>&, bool);

} // namespace riedel
