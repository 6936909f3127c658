/// One velocity component imposed on a box of nodes: a fixed side, a driven platen, a single pinned node, or a platen
/// that is free to move as a rigid body.
#pragma once

#include "core/step/boundaries/common_motion.hpp"

#include <optional>

namespace riedel {

/// A motion that is linear in the node row along `axis`: 0 in `fixed_row`, 1 in `moving_row`, also beyond them.
struct LinearMotion {
  int axis = 0;
  Index fixed_row = 0, moving_row = 1;
};

template <int Dim>
struct VelocityOnNodes {
  std::string name;
  Counts<Dim> first{}, last{};                         ///< corners of the box of nodes, inclusive
  int axis = 0;                                        ///< the component prescribed
  VelocityCourse velocity{};                           ///< [m/s]; none: free, with one motion for all nodes
  std::optional<LinearMotion> linear{};                ///< the nodes' factors of the velocity; none: all move alike
  std::optional<std::array<Counts<Dim>, 2>> but_for{}; ///< corners of an inner box of nodes that is left out
};

template <int Dim>
class PrescribedVelocity final : public CommonMotion<Dim> {
public:
  static constexpr std::string_view kind = "prescribed_velocity";
  static Keys parameters();

  explicit PrescribedVelocity(VelocityOnNodes<Dim> given);
  PrescribedVelocity(const std::string& name, const NodeBox<Dim>& place, const Values& values);

  void bind(const Grid<Dim>& grid, const ShapeFunction<Dim>& scheme) override;
  /// The row from which on, up to the grid's end, the velocity across it is prescribed from side to side.
  [[nodiscard]] std::array<Walls, Dim> walls(const Grid<Dim>& grid) const override;
  [[nodiscard]] const VelocityOnNodes<Dim>& given() const { return given_; }

private:
  VelocityOnNodes<Dim> given_;
};

/// `model.conditions.push_back(prescribe<2>({.name = "floor", .last = {20, 3}, .axis = 1, .velocity = still}))`
template <int Dim>
Boundary<Dim> prescribe(VelocityOnNodes<Dim> given) {
  return std::make_unique<PrescribedVelocity<Dim>>(std::move(given));
}

/// Several at once.
template <int Dim>
std::vector<Boundary<Dim>> prescribe_each(std::vector<VelocityOnNodes<Dim>> given) {
  std::vector<Boundary<Dim>> all;
  for (VelocityOnNodes<Dim>& one : given) all.push_back(prescribe<Dim>(std::move(one)));
  return all;
}

} // namespace riedel
