/// Common base of conditions whose nodes move together along a direction.
#pragma once

#include "core/interface/boundary_condition.hpp"
#include "core/step/boundaries/velocity_course.hpp"

namespace riedel {

/// Index of the axis for a direction that is not an axis.
constexpr int oblique = -1;

/// The direction of a motion.
template <int Dim>
struct Direction {
  int axis = 0;
  Vec<Dim> unit = Vec<Dim>::Zero(); ///< of unit length, if the axis is `oblique`

  [[nodiscard]] double along(const Vec<Dim>& v) const { return axis == oblique ? unit.dot(v) : v[axis]; }
  [[nodiscard]] Vec<Dim> vector() const { return axis == oblique ? unit : Vec<Dim>(Vec<Dim>::Unit(axis)); }
  /// Adds to the component along the direction; `set` assigns it, exactly to the bit along an axis.
  void add(Vec<Dim>& v, double change) const {
    if (axis == oblique)
      v += change * unit;
    else
      v[axis] += change;
  }
  void set(Vec<Dim>& v, double value) const {
    if (axis == oblique)
      v += (value - unit.dot(v)) * unit;
    else
      v[axis] = value;
  }
};

/// Nodes whose velocities along one direction follow a common motion v with a factor s_i each: v_i = s_i v.
template <int Dim>
class CommonMotion : public BoundaryCondition<Dim> {
public:
  /// The reaction is Σ m_i s_i (v_i − v_free,i)/Δt, and v is its conjugate velocity. If v is not given, it is Σ m_i s_i
  /// v_free,i / Σ m_i s_i², for which the reaction vanishes.
  void apply(BoundaryStep<Dim>& step) final;
  void apply_velocities(BoundaryStep<Dim>& step) final;

protected:
  /// @param velocity [m/s]; none: from the nodes' momentum
  CommonMotion(std::string name, Direction<Dim> direction, VelocityCourse velocity)
      : BoundaryCondition<Dim>(std::move(name)), direction_(direction), velocity_(std::move(velocity)) {}

  using BoundaryCondition<Dim>::nodes_;
  Direction<Dim> direction_;
  VelocityCourse velocity_;
  std::vector<double> factors_; ///< s_i of each node; empty: all 1

private:
  [[nodiscard]] double factor(std::size_t k) const { return factors_.empty() ? 1.0 : factors_[k]; }
  [[nodiscard]] double velocity_at(double time, const Nodes<Dim>& nodes) const;
};

} // namespace riedel
