#pragma once

#include "core/step/group_walk.hpp"
#include "core/step/kernels/point_contributions.hpp"
#include "core/step/kernels/point_motion.hpp"
#include "transfers/kit/pointwise.hpp"

namespace riedel {

template <int Dim, class Rule>
void PointwiseTransfer<Dim, Rule>::map_mass_and_momentum(State<Dim>& state, const Model<Dim>& model) const {
  sum_from_zero(state, model, [&](Body<Dim>& body) {
    return add_contributions<Use::weights>(state, model, body, mass_and_momentum<Dim>);
  });
}

template <int Dim, class Rule>
void PointwiseTransfer<Dim, Rule>::points_to_grid(State<Dim>& state, const Model<Dim>& model) const {
  const auto fill = [&](const Points<Dim>& points, Index p, PointContributions<Dim>& contributions) {
    mass_and_momentum(points, p, contributions);
    internal_forces(points, p, model.confining_pressure, contributions);
  };
  sum_from_zero(state, model, [&](Body<Dim>& body) { return add_contributions<Use::both>(state, model, body, fill); });
}

template <int Dim, class Rule>
void PointwiseTransfer<Dim, Rule>::move_points(State<Dim>& state, const Model<Dim>& model, double dt) const {
  const PhaseClock::Lap lap(state.clock, Phase::g2p);
  const auto motion = rule_.over(dt);
  for_each_gathered<Use::weights>(state, model, [&](const Gathered<Dim>& sum, Body<Dim>& body, Index p) {
    take_up<Dim>(motion(sum, body.points, p), body.points, p);
  });
}

template <int Dim, class Rule>
void PointwiseTransfer<Dim, Rule>::grid_to_points(State<Dim>& state, const Model<Dim>& model, double dt) const {
  const PhaseClock::Lap lap(state.clock, Phase::g2p);
  const auto motion = rule_.over(dt);
  for_each_gathered<Use::both>(state, model, [&](const Gathered<Dim>& sum, Body<Dim>& body, Index p) {
    take_up<Dim>(motion(sum, body.points, p), body.points, p);
    deform(sum, body.points, p, model, dt);
  });
}

template <int Dim, class Rule>
void PointwiseTransfer<Dim, Rule>::remap_velocity(State<Dim>& state, const Model<Dim>& model, double dt) const {
  const PhaseClock::Lap lap(state.clock, Phase::g2p);
  const auto motion = rule_.over(dt);
  clear_momentum(state.nodes);
  for (Body<Dim>& body : state.bodies)
    add_in_slab_order<PointContributions<Dim>>(
        state, model, body, [&](const SlabGroup<Dim>& group, PointContributions<Dim>& contributions) {
          Gathered<Dim> sum;
          gather<Use::weights>(group.stencil, state.nodes.motion, sum);
          const NewMotion<Dim> taken = motion(sum, body.points, group.first);
          keep<Dim>(taken, body, group);
          contributions.mass.put(momenta<Dim>(body.points, group.first, taken.velocity));
          scatter<Use::weights>(group, contributions, state.nodes);
        });
}

} // namespace riedel
