#include "core/step/transfers/affine.hpp"

#include "core/step/group_walk.hpp"
#include "core/step/kernels/point_motion.hpp"
#include "core/step/kernels/point_shares.hpp"
#include "core/step/transfers/affine_scatter.hpp"
#include "core/step/transfers/apic.hpp"
#include "core/step/transfers/tpic.hpp"

namespace riedel {

namespace {

/// Calls `body` with the transfer that the model names.
template <int Dim, class Body>
void with_transfer(const Model<Dim>& model, const Body& body) {
  if (model.transfer == VelocityTransfer::apic)
    body(Apic());
  else
    body(Tpic());
}

/// v_p and what is kept of its slope for eight points, from the grid; they move, too.
template <class Transfer, int Dim>
void take_up(const StencilGroup<Dim>& stencil, State<Dim>& state, Points<Dim>& points, Index p, double dt,
             Gathered<Dim>& sum) {
  const Moments<Dim> moments = moments_of<Dim>(stencil, state.grid, points, p, room_for_moments(state));
  const PackMatrix<Dim> columns = Transfer::template gather_slope<Dim>(stencil, moments.first, state.nodes, sum);
  const NewMotion<Dim> motion = new_motion(sum, points, p, 0.0, dt);
  for (int i = 0; i < Dim; ++i) {
    motion.velocity[i].store(points.velocity[i] + p);
    for (int a = 0; a < Dim; ++a) columns[a][i].store(points.affine[i * Dim + a] + p);
  }
  move(points, p, motion.way);
}

/// Working space of a slab.
template <int Dim>
struct Space {
  Shares<Dim> shares;
  AffineShares<Dim> affine;
};

} // namespace

template <Use use, int Dim>
void affine_points_to_grid(State<Dim>& state, const Model<Dim>& model) {
  with_transfer(model, [&]<class Transfer>(Transfer) {
    const auto add = [&](const Points<Dim>& points, const SlabGroup<Dim>& group, Space<Dim>& space) {
      const Index p = group.first;
      const Moments<Dim> moments = moments_of<Dim>(group.stencil, state.grid, points, p, room_for_moments(state));
      put_mass_and_momentum(points, p, space.shares);
      space.affine.mass = space.shares.mass;
      space.affine.put_slope(Pack::load(points.mass[0] + p),
                             Transfer::template slope<Dim>(load_matrix<Dim>(points.affine, p), moments.second));
      scatter_affine(moments.first, group.lanes, space.affine, state.nodes);
      if constexpr (use == Use::both) {
        put_forces(points, p, model.confining_pressure, space.shares);
        scatter<Use::slopes>(group, space.shares, state.nodes);
      }
    };
    sum_from_zero(state, model, [&](Body<Dim>& body) {
      return add_in_slab_order<Space<Dim>>(
          state, model, body, [&](const SlabGroup<Dim>& group, Space<Dim>& space) { add(body.points, group, space); });
    });
  });
}

template <int Dim>
void affine_move_points(State<Dim>& state, const Model<Dim>& model, double dt) {
  const PhaseClock::Lap lap(state.clock, Phase::g2p);
  with_transfer(model, [&]<class Transfer>(Transfer) {
    for_each_group(state, model, [&](Body<Dim>& body, const StencilGroup<Dim>& stencil, Index p) {
      Gathered<Dim> sum;
      take_up<Transfer>(stencil, state, body.points, p, dt, sum);
    });
  });
}

template <int Dim>
void affine_grid_to_points(State<Dim>& state, const Model<Dim>& model, double dt) {
  const PhaseClock::Lap lap(state.clock, Phase::g2p);
  with_transfer(model, [&]<class Transfer>(Transfer) {
    for_each_group(state, model, [&](Body<Dim>& body, const StencilGroup<Dim>& stencil, Index p) {
      Gathered<Dim> sum;
      take_up<Transfer>(stencil, state, body.points, p, dt, sum);
      if constexpr (!Transfer::keeps_gradient) gather<Use::slopes>(stencil, state.nodes.motion, sum);
      deform(sum, body.points, p, model, dt);
    });
  });
}

template <int Dim>
void affine_remap_velocity(State<Dim>& state, const Model<Dim>& model, double dt) {
  const PhaseClock::Lap lap(state.clock, Phase::g2p);
  parallel_for(state.nodes.size(), [&](Index i) { state.nodes.sums[i].momentum.setZero(); });
  with_transfer(model, [&]<class Transfer>(Transfer) {
    const auto remap = [&](Body<Dim>& body, const SlabGroup<Dim>& group, AffineShares<Dim>& shares) {
      Points<Dim>& points = body.points;
      const Index p = group.first;
      const Moments<Dim> moments = moments_of<Dim>(group.stencil, state.grid, points, p, room_for_moments(state));
      Gathered<Dim> sum;
      const PackMatrix<Dim> columns =
          Transfer::template gather_slope<Dim>(group.stencil, moments.first, state.nodes, sum);
      const NewMotion<Dim> motion = new_motion(sum, points, p, 0.0, dt);
      const Pack m = Pack::load(points.mass[0] + p);
      std::array<Pack, 4> momenta; // without mass, which the nodes have already
      momenta.fill(Pack(0.0));
      PackMatrix<Dim> kept;
      for (int i = 0; i < Dim; ++i) {
        store_lanes(points.velocity[i] + p, motion.velocity[i], group.lanes);
        store_lanes(body.way[i] + p, motion.way[i], group.lanes);
        momenta[i] = m * motion.velocity[i];
        for (int a = 0; a < Dim; ++a) {
          kept[i][a] = columns[a][i];
          store_lanes(points.affine[i * Dim + a] + p, kept[i][a], group.lanes);
        }
      }
      shares.mass.put(momenta);
      shares.put_slope(m, Transfer::template slope<Dim>(kept, moments.second));
      scatter_affine(moments.first, group.lanes, shares, state.nodes);
    };
    for (Body<Dim>& body : state.bodies)
      add_in_slab_order<AffineShares<Dim>>(
          state, model, body,
          [&](const SlabGroup<Dim>& group, AffineShares<Dim>& shares) { remap(body, group, shares); });
  });
}

template void affine_points_to_grid<Use::values, 2>(State<2>&, const Model<2>&);
template void affine_points_to_grid<Use::values, 3>(State<3>&, const Model<3>&);
template void affine_points_to_grid<Use::both, 2>(State<2>&, const Model<2>&);
template void affine_points_to_grid<Use::both, 3>(State<3>&, const Model<3>&);
template void affine_move_points<2>(State<2>&, const Model<2>&, double);
template void affine_move_points<3>(State<3>&, const Model<3>&, double);
template void affine_grid_to_points<2>(State<2>&, const Model<2>&, double);
template void affine_grid_to_points<3>(State<3>&, const Model<3>&, double);
template void affine_remap_velocity<2>(State<2>&, const Model<2>&, double);
template void affine_remap_velocity<3>(State<3>&, const Model<3>&, double);

} // namespace riedel
