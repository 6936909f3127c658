#include "core/step/grid_to_points.hpp"

#include "core/step/point_motion.hpp"
#include "core/step/scatter.hpp"
#include "core/step/transfer.hpp"

namespace riedel {

namespace {

/// Calls `take(sum, body, p)` for every eight points of all bodies, with what they gather from the grid.
template <Use use, int Dim, class Take>
void for_each_group(State<Dim>& state, const Model<Dim>& model, const Take& take) {
  for (Body<Dim>& body : state.bodies)
    for_each_block(body.points.size(), [&](Range whole) {
      Gathered<Dim> sum;
      for (Index b = whole.begin; b < whole.end; b += stencil_block) {
        const Range block{b, std::min(b + stencil_block, whole.end)};
        const Stencils<Dim>& stencils = body.stencils.of(*model.scheme, state.grid, body.points, block, state.clock);
        for (Index p = b; p < block.end; p += pack_size) {
          gather<use>(stencils.group_of(p), state.nodes, sum);
          take(sum, body, p);
        }
      }
    });
}

/// New velocities and positions.
template <int Dim>
void move(const Gathered<Dim>& sum, Points<Dim>& points, Index p, double flip, double dt) {
  const NewMotion<Dim> motion = new_motion(sum, points, p, flip, dt);
  for (int a = 0; a < Dim; ++a) motion.velocity[a].store(points.velocity[a] + p);
  move(points, p, motion.way);
}

/// The lanes of a group that belong to its slab; the others are another thread's.
void store_lanes(double* column, const Pack& values, Range lanes) {
  if (lanes.size() == pack_size) return values.store(column);
  std::array<double, pack_size> lane;
  values.store(lane.data());
  std::copy(lane.begin() + lanes.begin, lane.begin() + lanes.end, column + lanes.begin);
}

} // namespace

template <int Dim>
void move_points(State<Dim>& state, const Model<Dim>& model, double dt) {
  const PhaseClock::Lap lap(state.clock, Phase::g2p);
  for_each_group<Use::values>(state, model, [&](const Gathered<Dim>& sum, Body<Dim>& body, Index p) {
    move(sum, body.points, p, model.flip, dt);
  });
}

template <int Dim>
void update_kinematics(State<Dim>& state, const Model<Dim>& model, double dt) {
  const PhaseClock::Lap lap(state.clock, Phase::kinematics);
  for_each_group<Use::slopes>(
      state, model, [&](const Gathered<Dim>& sum, Body<Dim>& body, Index p) { deform(sum, body.points, p, dt); });
}

template <int Dim>
void grid_to_points(State<Dim>& state, const Model<Dim>& model, double dt) {
  const PhaseClock::Lap lap(state.clock, Phase::g2p);
  for_each_group<Use::both>(state, model, [&](const Gathered<Dim>& sum, Body<Dim>& body, Index p) {
    move(sum, body.points, p, model.flip, dt);
    deform(sum, body.points, p, dt);
  });
}

template <int Dim>
void remap_velocity(State<Dim>& state, const Model<Dim>& model, double dt) {
  {
    const PhaseClock::Lap lap(state.clock, Phase::g2p);
    parallel_for(state.nodes.size(), [&](Index i) { state.nodes.sums[i].momentum.setZero(); });
    for (Body<Dim>& body : state.bodies)
      add_in_slab_order<Shares<Dim>>(state, model, body, [&](const SlabGroup<Dim>& group, Shares<Dim>& shares) {
        Points<Dim>& points = body.points;
        Gathered<Dim> sum;
        gather<Use::values>(group.stencil, state.nodes, sum);
        const NewMotion<Dim> motion = new_motion(sum, points, group.first, model.flip, dt);
        const Pack m = Pack::load(points.mass[0] + group.first);
        std::array<Pack, 4> momenta; // without mass, which the nodes have already
        momenta.fill(Pack(0.0));
        for (int a = 0; a < Dim; ++a) {
          store_lanes(points.velocity[a] + group.first, motion.velocity[a], group.lanes);
          store_lanes(body.way[a] + group.first, motion.way[a], group.lanes);
          momenta[a] = m * motion.velocity[a];
        }
        shares.mass.put(momenta);
        scatter<Use::values>(group, shares, state.nodes);
      });
  }
  divide_momentum(state, model);
}

template <int Dim>
void deform_and_move(State<Dim>& state, const Model<Dim>& model, double dt) {
  const PhaseClock::Lap lap(state.clock, Phase::kinematics);
  for_each_group<Use::slopes>(state, model, [&](const Gathered<Dim>& sum, Body<Dim>& body, Index p) {
    deform(sum, body.points, p, dt);
    std::array<Pack, Dim> way;
    for (int a = 0; a < Dim; ++a) way[a] = Pack::load(body.way[a] + p);
    move(body.points, p, way);
  });
}

template <int Dim>
void move_scheme_columns(State<Dim>& state, const Model<Dim>& model, double dt) {
  if (model.scheme->columns() == 0) return;
  const PhaseClock::Lap lap(state.clock, Phase::kinematics);
  for (Body<Dim>& body : state.bodies)
    for_each_block(body.points.size(),
                   [&](Range block) { model.scheme->move(state.grid, state.nodes, dt, body.points, block); });
}

template void move_scheme_columns<2>(State<2>&, const Model<2>&, double);
template void move_scheme_columns<3>(State<3>&, const Model<3>&, double);
template void move_points<2>(State<2>&, const Model<2>&, double);
template void move_points<3>(State<3>&, const Model<3>&, double);
template void update_kinematics<2>(State<2>&, const Model<2>&, double);
template void update_kinematics<3>(State<3>&, const Model<3>&, double);
template void grid_to_points<2>(State<2>&, const Model<2>&, double);
template void grid_to_points<3>(State<3>&, const Model<3>&, double);
template void remap_velocity<2>(State<2>&, const Model<2>&, double);
template void remap_velocity<3>(State<3>&, const Model<3>&, double);
template void deform_and_move<2>(State<2>&, const Model<2>&, double);
template void deform_and_move<3>(State<3>&, const Model<3>&, double);

} // namespace riedel
