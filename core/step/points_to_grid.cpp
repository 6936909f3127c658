#include "core/step/points_to_grid.hpp"

#include "core/step/boundary.hpp"
#include "core/step/kernels/point_contributions.hpp"

namespace riedel {

namespace {

/// Calls `add(i, power)` for every node, and sums the powers block by block.
template <int Dim, class Add>
NodePower sum_over_nodes(State<Dim>& state, const Add& add) {
  return reduce_blocks(
      state.nodes.size(), state.node_powers, NodePower{},
      [&](Range range) {
        NodePower power;
        for (Index i = range.begin; i < range.end; ++i) add(i, power);
        return power;
      },
      [](NodePower sum, const NodePower& part) {
        return NodePower{.start = sum.start + part.start, .end = sum.end + part.end};
      });
}

/// Minimum mass of a node that carries motion.
template <int Dim>
double min_mass(const State<Dim>& state, const Model<Dim>& model) {
  return model.scheme->mass_cutoff() * state.bodies.front().points.mass[0][0];
}

} // namespace

template <int Dim>
void map_forces(State<Dim>& state, const Model<Dim>& model) {
  const PhaseClock::Lap lap(state.clock, Phase::p2g);
  for (Body<Dim>& body : state.bodies)
    add_contributions<Use::gradients>(state, model, body,
                                      [&](const Points<Dim>& points, Index p, PointContributions<Dim>& contributions) {
                                        internal_forces(points, p, model.confining_pressure, contributions);
                                      });
}

template <int Dim>
void advance_momentum(State<Dim>& state, const Model<Dim>& model, double dt) {
  const PhaseClock::Lap lap(state.clock, Phase::grid);
  remember_velocities(state, model);
  const double minimum = min_mass(state, model);
  const bool first = state.step == 0; // no previous strains
  state.node_power = sum_over_nodes(state, [&](Index i, NodePower& power) {
    const NodeSums<Dim>& sums = state.nodes.sums[i];
    NodeMotion<Dim>& motion = state.nodes.motion[i];
    if (sums.mass > minimum) {
      const double per_mass = 1.0 / sums.mass;
      const Vec<Dim> before = first ? Vec<Dim>(per_mass * sums.momentum) : motion.velocity;
      motion.acceleration = per_mass * sums.force + model.gravity;
      motion.velocity = per_mass * sums.momentum + dt * motion.acceleration;
      power.start += sums.mass * motion.acceleration.dot(before);
      power.end += sums.mass * motion.acceleration.dot(motion.velocity);
    } else {
      motion = {};
    }
  });
}

template <int Dim>
void divide_momentum(State<Dim>& state, const Model<Dim>& model) {
  const PhaseClock::Lap lap(state.clock, Phase::grid);
  const double minimum = min_mass(state, model);
  const NodePower power = sum_over_nodes(state, [&](Index i, NodePower& sum) {
    const NodeSums<Dim>& sums = state.nodes.sums[i];
    NodeMotion<Dim>& motion = state.nodes.motion[i];
    if (sums.mass > minimum) {
      motion.velocity = sums.momentum * (1.0 / sums.mass);
      sum.end += motion.acceleration.dot(sums.momentum);
    } else {
      motion = {};
    }
  });
  state.node_power.end = power.end;
}

template void map_forces<2>(State<2>&, const Model<2>&);
template void map_forces<3>(State<3>&, const Model<3>&);
template void advance_momentum<2>(State<2>&, const Model<2>&, double);
template void advance_momentum<3>(State<3>&, const Model<3>&, double);
template void divide_momentum<2>(State<2>&, const Model<2>&);
template void divide_momentum<3>(State<3>&, const Model<3>&);

} // namespace riedel
