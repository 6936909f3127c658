/// A rigid block of points that moves through the grid and imposes its velocity, along one direction, on every node
/// that its stencils touch: the paper's platen. Nodes enter and leave it in whole cells: its force is a saw-tooth.
#pragma once

#include "core/step/boundaries/common_motion.hpp"

namespace riedel {

template <int Dim>
struct RigidPoints {
  std::string name;
  Points<Dim> points{};
  Direction<Dim> direction{};
  VelocityCourse velocity{}; ///< [m/s]
};

template <int Dim>
class RigidBody final : public CommonMotion<Dim> {
public:
  static constexpr std::string_view kind = "rigid_body";
  static Keys parameters();

  explicit RigidBody(RigidPoints<Dim> given);
  /// Puts a point in each of the cells between the nodes of the box.
  RigidBody(const std::string& name, const NodeBox<Dim>& place, const Values& values);

  void bind(const Grid<Dim>& grid, const ShapeFunction<Dim>& scheme) override;
  /// Finds the nodes that its points touch; throws RunError if one leaves the grid.
  void follow(const Grid<Dim>& grid, const ShapeFunction<Dim>& scheme) override;
  void move(double time, double dt) override;
  [[nodiscard]] const Points<Dim>* points() const override { return &points_; }

private:
  Points<Dim> points_;
  Stencils<Dim> stencils_;
  NodeBox<Dim> cells_{}; ///< to be filled with points
};

} // namespace riedel
