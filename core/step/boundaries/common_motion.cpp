#include "core/step/boundaries/common_motion.hpp"

namespace riedel {

/// If the velocity is free, it is the one that conserves the nodes' momentum along the motion.
template <int Dim>
double CommonMotion<Dim>::velocity_at(double time, const Nodes<Dim>& nodes) const {
  if (velocity_) return velocity_(time);
  double momentum = 0.0, mass = 0.0;
  for (std::size_t k = 0; k < nodes_.size(); ++k) {
    const Index i = nodes_[k];
    const double m = nodes.sums[i].mass * factor(k);
    momentum += m * direction_.along(nodes.motion[i].velocity);
    mass += m * factor(k);
  }
  return mass > 0.0 ? momentum / mass : 0.0;
}

template <int Dim>
void CommonMotion<Dim>::apply(BoundaryStep<Dim>& step) {
  const double speed_before = this->report_.speed, speed = velocity_at(step.time, step.nodes);
  double impulse = 0.0, all = 0.0; // of the motion, of the material
  for (std::size_t k = 0; k < nodes_.size(); ++k) {
    const Index i = nodes_[k];
    NodeMotion<Dim>& motion = step.nodes.motion[i];
    const double v = factor(k) * speed, free = direction_.along(motion.velocity), change = v - free;
    const double mass = step.nodes.sums[i].mass;
    const double force = mass * direction_.along(motion.acceleration), change_of_force = mass * change / step.dt;
    impulse += factor(k) * mass * change;
    all += mass * change;
    step.power.start += change_of_force * factor(k) * speed_before;
    step.power.end += (force + change_of_force) * v - force * free;
    direction_.set(motion.velocity, v);
    direction_.add(motion.acceleration, change / step.dt);
  }
  this->report_ = {.speed = speed,
                   .reaction = impulse / step.dt,
                   .force = all / step.dt * direction_.vector(),
                   .work = impulse * speed};
}

template <int Dim>
void CommonMotion<Dim>::apply_velocities(BoundaryStep<Dim>& step) {
  const double speed = velocity_at(step.time, step.nodes);
  for (std::size_t k = 0; k < nodes_.size(); ++k) {
    const Index i = nodes_[k];
    NodeMotion<Dim>& motion = step.nodes.motion[i];
    const double v = factor(k) * speed, change = v - direction_.along(motion.velocity);
    step.power.end += step.nodes.sums[i].mass * direction_.along(motion.acceleration) * change;
    direction_.set(motion.velocity, v);
  }
}

template class CommonMotion<2>;
template class CommonMotion<3>;

} // namespace riedel
