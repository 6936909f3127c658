/// What conditions share whose nodes move as one along a direction.
#pragma once

#include "core/interface/boundary_condition.hpp"
#include "core/step/boundaries/velocity_course.hpp"

namespace riedel {

/// A direction that is none of the axes: an index of the axis that says so.
constexpr int oblique = -1;

/// The direction of a motion.
template <int Dim>
struct Direction {
  int axis = 0;
  Vec<Dim> unit = Vec<Dim>::Zero(); ///< of unit length, where the axis is `oblique`

  [[nodiscard]] double along(const Vec<Dim>& v) const { return axis == oblique ? unit.dot(v) : v[axis]; }
  [[nodiscard]] Vec<Dim> vector() const { return axis == oblique ? unit : Vec<Dim>(Vec<Dim>::Unit(axis)); }
  /// Adds to the component along the direction; `set` gives it a value, along an axis to the bit.
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

/// Nodes whose velocities along one direction are one motion's, each its factor s_i of it: v_i = s_i v.
template <int Dim>
class CommonMotion : public BoundaryCondition<Dim> {
public:
  /// The reaction is Σ m_i s_i (v_i − v_free,i)/Δt, and its work that with v. Where v is not given it is
  /// Σ m_i s_i v_free,i / Σ m_i s_i², for which the reaction vanishes.
  void apply(BoundaryStep<Dim>& step) final;
  void apply_velocities(BoundaryStep<Dim>& step) final;

protected:
  /// @param velocity [m/s]; none: that of the nodes' momentum
  CommonMotion(std::string name, Direction<Dim> direction, VelocityCourse velocity)
      : BoundaryCondition<Dim>(std::move(name)), direction_(direction), velocity_(std::move(velocity)) {}

  using BoundaryCondition<Dim>::nodes_;
  Direction<Dim> direction_;
  VelocityCourse velocity_;
  std::vector<double> factors_; ///< s_i by node; empty: all 1

private:
  [[nodiscard]] double factor(std::size_t k) const { return factors_.empty() ? 1.0 : factors_[k]; }
  [[nodiscard]] double velocity_at(double time, const Nodes<Dim>& nodes) const;
};

} // namespace riedel
