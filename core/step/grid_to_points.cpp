#include "core/step/grid_to_points.hpp"

#include "core/step/group_walk.hpp"
#include "core/step/kernels/point_motion.hpp"
#include "core/step/kernels/scatter.hpp"
#include "core/step/transfer.hpp"
#include "core/step/transfers/affine.hpp"

namespace riedel {

namespace {

/// Calls `take(sum, body, p)` for every eight points of all bodies, with what they gather from the grid.
template <Use use, int Dim, class Take>
void for_each_gathered(State<Dim>& state, const Model<Dim>& model, const Take& take) {
  for_each_group(state, model, [&](Body<Dim>& body, const StencilGroup<Dim>& stencil, Index p) {
    Gathered<Dim> sum;
    gather<use>(stencil, state.nodes.motion, sum);
    take(sum, body, p);
  });
}

/// New velocities and positions.
template <int Dim>
void move(const Gathered<Dim>& sum, Points<Dim>& points, Index p, double flip, double dt) {
  const NewMotion<Dim> motion = new_motion(sum, points, p, flip, dt);
  for (int a = 0; a < Dim; ++a) motion.velocity[a].store(points.velocity[a] + p);
  move(points, p, motion.way);
}

/// XPIC has filtered the points' velocities, and FLIP's update of these is left.
template <int Dim>
double share_of_flip(const Model<Dim>& model, double dt) {
  if (model.transfer == VelocityTransfer::xpic) return 1.0;
  return model.damping ? std::exp(-*model.damping * dt) : model.flip;
}

} // namespace

template <int Dim>
void move_points(State<Dim>& state, const Model<Dim>& model, double dt) {
  if (is_affine(model.transfer)) return affine_move_points(state, model, dt);
  const PhaseClock::Lap lap(state.clock, Phase::g2p);
  const double flip = share_of_flip(model, dt);
  for_each_gathered<Use::values>(
      state, model, [&](const Gathered<Dim>& sum, Body<Dim>& body, Index p) { move(sum, body.points, p, flip, dt); });
}

template <int Dim>
void update_kinematics(State<Dim>& state, const Model<Dim>& model, double dt) {
  const PhaseClock::Lap lap(state.clock, Phase::kinematics);
  for_each_gathered<Use::slopes>(state, model, [&](const Gathered<Dim>& sum, Body<Dim>& body, Index p) {
    deform(sum, body.points, p, model, dt);
  });
}

template <int Dim>
void grid_to_points(State<Dim>& state, const Model<Dim>& model, double dt) {
  if (is_affine(model.transfer)) return affine_grid_to_points(state, model, dt);
  const PhaseClock::Lap lap(state.clock, Phase::g2p);
  const double flip = share_of_flip(model, dt);
  for_each_gathered<Use::both>(state, model, [&](const Gathered<Dim>& sum, Body<Dim>& body, Index p) {
    move(sum, body.points, p, flip, dt);
    deform(sum, body.points, p, model, dt);
  });
}

template <int Dim>
void remap_velocity(State<Dim>& state, const Model<Dim>& model, double dt) {
  if (is_affine(model.transfer)) {
    affine_remap_velocity(state, model, dt);
  } else {
    const double flip = share_of_flip(model, dt);
    const PhaseClock::Lap lap(state.clock, Phase::g2p);
    parallel_for(state.nodes.size(), [&](Index i) { state.nodes.sums[i].momentum.setZero(); });
    for (Body<Dim>& body : state.bodies)
      add_in_slab_order<Shares<Dim>>(state, model, body, [&](const SlabGroup<Dim>& group, Shares<Dim>& shares) {
        Points<Dim>& points = body.points;
        Gathered<Dim> sum;
        gather<Use::values>(group.stencil, state.nodes.motion, sum);
        const NewMotion<Dim> motion = new_motion(sum, points, group.first, flip, dt);
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
  for_each_gathered<Use::slopes>(state, model, [&](const Gathered<Dim>& sum, Body<Dim>& body, Index p) {
    deform(sum, body.points, p, model, dt);
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
