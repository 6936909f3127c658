/// Common base of conditions that treat every node separately: a condition provides the formula for one node, the
/// library the loop and the energy balance.
#pragma once

#include "core/step/boundaries/node_box.hpp"

namespace riedel {

/// A node after the momentum balance, before the condition acts.
template <int Dim>
struct FreeNode {
  std::size_t k = 0; ///< its index among the nodes of the condition
  double mass = 0.0; ///< [kg or kg/m]
  Vec<Dim> velocity; ///< [m/s]
  double time, dt;   ///< end and length of the step [s]
};

/// `Law` provides, in addition to its overrides,
///   Vec<Dim> velocity(const FreeNode<Dim>& node)       the node's velocity as the boundary changes it,
///   Vec<Dim> velocity_alone(const FreeNode<Dim>& node) the same after a remap, without a force (dt, mass not set),
///   Vec<Dim> motion(double time) const                 the boundary's velocity.
template <class Law, int Dim>
class Nodewise : public BoundaryCondition<Dim> {
public:
  void bind(const Grid<Dim>& grid, const ShapeFunction<Dim>&) override { take(nodes_in(grid, place_)); }
  void remember(const Nodes<Dim>& nodes) final;
  void apply(BoundaryStep<Dim>& step) final;
  void apply_velocities(BoundaryStep<Dim>& step) final;

protected:
  Nodewise(std::string name, const NodeBox<Dim>& place) : BoundaryCondition<Dim>(std::move(name)), place_(place) {}
  /// Sets the nodes of the condition.
  void take(std::vector<Index> nodes) {
    this->nodes_ = std::move(nodes);
    before_.assign(this->nodes_.size(), Vec<Dim>::Zero());
    first_ = true;
  }

  NodeBox<Dim> place_;

private:
  Law& law() { return static_cast<Law&>(*this); }

  std::vector<Vec<Dim>> before_; ///< velocities from which the last strains were computed [m/s]
  bool first_ = true;            ///< there are no strains yet
};

template <class Law, int Dim>
void Nodewise<Law, Dim>::remember(const Nodes<Dim>& nodes) {
  for (std::size_t k = 0; k < before_.size(); ++k) {
    const Index i = this->nodes_[k];
    const NodeSums<Dim>& sums = nodes.sums[i];
    before_[k] = first_ && sums.mass > 0.0 ? Vec<Dim>(sums.momentum / sums.mass) : nodes.motion[i].velocity;
  }
  first_ = false;
}

/// Force and motion act together from the start of the step, with the previous velocity, to its end.
template <class Law, int Dim>
void Nodewise<Law, Dim>::apply(BoundaryStep<Dim>& step) {
  Vec<Dim> total = Vec<Dim>::Zero();
  double work = 0.0;
  for (std::size_t k = 0; k < before_.size(); ++k) {
    const Index i = this->nodes_[k];
    NodeMotion<Dim>& motion = step.nodes.motion[i];
    const Vec<Dim> free = motion.velocity;
    const double mass = step.nodes.sums[i].mass;
    const Vec<Dim> v = law().velocity(FreeNode<Dim>{k, mass, free, step.time, step.dt}), change = v - free;
    const Vec<Dim> impulse = mass * change;
    total += impulse;
    work += 0.5 * impulse.dot(before_[k] + v);
    step.power.start += impulse.dot(before_[k]) / step.dt;
    step.power.end += (mass * motion.acceleration + impulse / step.dt).dot(v) - mass * motion.acceleration.dot(free);
    motion.velocity = v;
    motion.acceleration += change / step.dt;
  }
  const Vec<Dim> own = law().motion(step.time);
  const double speed = own.norm();
  const Vec<Dim> direction = speed > 0.0 ? Vec<Dim>(own / speed) : Vec<Dim>(Vec<Dim>::Unit(place_.axis));
  this->report_ = {.speed = speed,
                   .reaction = total.dot(direction) / step.dt,
                   .force = total / step.dt,
                   .work = work,
                   .dissipated = total.dot(own) - work};
}

template <class Law, int Dim>
void Nodewise<Law, Dim>::apply_velocities(BoundaryStep<Dim>& step) {
  for (std::size_t k = 0; k < before_.size(); ++k) {
    const Index i = this->nodes_[k];
    NodeMotion<Dim>& motion = step.nodes.motion[i];
    const Vec<Dim> v = law().velocity_alone(FreeNode<Dim>{k, 0.0, motion.velocity, step.time, 0.0});
    step.power.end += step.nodes.sums[i].mass * motion.acceleration.dot(v - motion.velocity);
    motion.velocity = v;
  }
}

} // namespace riedel
