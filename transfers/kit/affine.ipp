#pragma once

#include "core/step/group_walk.hpp"
#include "core/step/kernels/point_contributions.hpp"
#include "core/step/kernels/point_motion.hpp"
#include "transfers/kit/affine.hpp"
#include "transfers/kit/affine_scatter.hpp"

namespace riedel {

/// Working space of a slab.
template <int Dim>
struct AffineSpace {
  PointContributions<Dim> contributions;
  AffineShares<Dim> affine;
};

/// The first sums of a step: only mass and momentum, which are the values, or the forces in addition.
template <Use use, class Gradient, int Dim>
void sum_affine(State<Dim>& state, const Model<Dim>& model) {
  const auto add = [&](const Points<Dim>& points, const SlabGroup<Dim>& group, AffineSpace<Dim>& space) {
    const Index p = group.first;
    const Moments<Dim> moments =
        moments_of<Dim>(group.stencil, state.grid, points, p, state.transfer_room.of_this_thread());
    mass_and_momentum(points, p, space.contributions);
    space.affine.mass = space.contributions.mass;
    space.affine.put_gradient(Pack::load(points.mass[0] + p),
                              Gradient::gradient(load_matrix<Dim>(points.transfer_data, p), moments.second));
    scatter_affine(moments.first, group.lanes, space.affine, state.nodes);
    if constexpr (use == Use::both) {
      internal_forces(points, p, model.confining_pressure, space.contributions);
      scatter<Use::gradients>(group, space.contributions, state.nodes);
    }
  };
  sum_from_zero(state, model, [&](Body<Dim>& body) {
    return add_in_slab_order<AffineSpace<Dim>>(
        state, model, body,
        [&](const SlabGroup<Dim>& group, AffineSpace<Dim>& space) { add(body.points, group, space); });
  });
}

/// v_p and the stored gradient for eight points, from the grid; also moves them.
template <class Gradient, int Dim, class Motion>
void take_up_affine(const StencilGroup<Dim>& stencil, State<Dim>& state, Points<Dim>& points, Index p,
                    const Motion& motion, Gathered<Dim>& sum) {
  const Moments<Dim> moments = moments_of<Dim>(stencil, state.grid, points, p, state.transfer_room.of_this_thread());
  const PackMatrix<Dim> columns = Gradient::gather(stencil, moments.first, state.nodes, sum);
  const NewMotion<Dim> taken = motion(sum, points, p);
  for (int i = 0; i < Dim; ++i)
    for (int a = 0; a < Dim; ++a) columns[a][i].store(points.transfer_data[i * Dim + a] + p);
  take_up<Dim>(taken, points, p);
}

template <int Dim, class Gradient, class Rule>
void AffineTransfer<Dim, Gradient, Rule>::map_mass_and_momentum(State<Dim>& state, const Model<Dim>& model) const {
  sum_affine<Use::weights, Gradient>(state, model);
}

template <int Dim, class Gradient, class Rule>
void AffineTransfer<Dim, Gradient, Rule>::points_to_grid(State<Dim>& state, const Model<Dim>& model) const {
  sum_affine<Use::both, Gradient>(state, model);
}

template <int Dim, class Gradient, class Rule>
void AffineTransfer<Dim, Gradient, Rule>::move_points(State<Dim>& state, const Model<Dim>& model, double dt) const {
  const PhaseClock::Lap lap(state.clock, Phase::g2p);
  const auto motion = rule_.over(dt);
  for_each_group(state, model, [&](Body<Dim>& body, const StencilGroup<Dim>& stencil, Index p) {
    Gathered<Dim> sum;
    take_up_affine<Gradient>(stencil, state, body.points, p, motion, sum);
  });
}

template <int Dim, class Gradient, class Rule>
void AffineTransfer<Dim, Gradient, Rule>::grid_to_points(State<Dim>& state, const Model<Dim>& model, double dt) const {
  const PhaseClock::Lap lap(state.clock, Phase::g2p);
  const auto motion = rule_.over(dt);
  for_each_group(state, model, [&](Body<Dim>& body, const StencilGroup<Dim>& stencil, Index p) {
    Gathered<Dim> sum;
    take_up_affine<Gradient>(stencil, state, body.points, p, motion, sum);
    if constexpr (!Gradient::keeps_gradient) gather<Use::gradients>(stencil, state.nodes.motion, sum);
    deform(sum, body.points, p, model, dt);
  });
}

template <int Dim, class Gradient, class Rule>
void AffineTransfer<Dim, Gradient, Rule>::remap_velocity(State<Dim>& state, const Model<Dim>& model, double dt) const {
  const PhaseClock::Lap lap(state.clock, Phase::g2p);
  const auto motion = rule_.over(dt);
  clear_momentum(state.nodes);
  const auto remap = [&](Body<Dim>& body, const SlabGroup<Dim>& group, AffineShares<Dim>& contributions) {
    Points<Dim>& points = body.points;
    const Index p = group.first;
    const Moments<Dim> moments =
        moments_of<Dim>(group.stencil, state.grid, points, p, state.transfer_room.of_this_thread());
    Gathered<Dim> sum;
    const PackMatrix<Dim> columns = Gradient::gather(group.stencil, moments.first, state.nodes, sum);
    const NewMotion<Dim> taken = motion(sum, points, p);
    keep<Dim>(taken, body, group);
    PackMatrix<Dim> kept;
    for (int i = 0; i < Dim; ++i)
      for (int a = 0; a < Dim; ++a) {
        kept[i][a] = columns[a][i];
        store_lanes(points.transfer_data[i * Dim + a] + p, kept[i][a], group.lanes);
      }
    contributions.mass.put(momenta<Dim>(points, p, taken.velocity));
    contributions.put_gradient(Pack::load(points.mass[0] + p), Gradient::gradient(kept, moments.second));
    scatter_affine(moments.first, group.lanes, contributions, state.nodes);
  };
  for (Body<Dim>& body : state.bodies)
    add_in_slab_order<AffineShares<Dim>>(
        state, model, body,
        [&](const SlabGroup<Dim>& group, AffineShares<Dim>& contributions) { remap(body, group, contributions); });
}

} // namespace riedel
