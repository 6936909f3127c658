/// Velocities prescribed on nodes, and the forces that this takes.
#pragma once

#include "core/interface/shape_function.hpp"
#include "core/step/state.hpp"

namespace riedel {

/// One velocity component prescribed on a box of nodes: a fixed side, a driven platen, or a single pinned node.
template <int Dim>
struct NodeCondition {
  std::string name;
  Counts<Dim> first{}, last{};                 ///< corners of the box of nodes, both included
  int axis = 0;                                ///< the component held
  std::function<double(double time)> velocity; ///< [m/s]
};

/// @return speed ramped smoothly from zero to `speed` over `ramp_time`
std::function<double(double)> ramped(double speed, double ramp_time);

/// Numbers of the nodes in the condition's box.
template <int Dim>
std::vector<Index> nodes_of(const Grid<Dim>& grid, const NodeCondition<Dim>& condition);

/// Rows of nodes from which on, to the grid's end, a condition holds the velocity across them: walls. Of two on one
/// side, the inner one.
template <int Dim>
std::array<Walls, Dim> walls_of(const Grid<Dim>& grid, const std::vector<NodeCondition<Dim>>& conditions);

/// Makes state.held from the conditions and the rigid bodies, in this order, and finds the grid's walls.
template <int Dim>
void bind_conditions(State<Dim>& state, const std::vector<NodeCondition<Dim>>& conditions);

/// Finds the nodes that each rigid body touches now; throws RunError when one leaves the grid.
template <int Dim>
void find_rigid_nodes(State<Dim>& state, const ShapeFunction<Dim>& scheme);

/// Moves the rigid bodies through one step that ends at `time`.
template <int Dim>
void move_rigid_points(State<Dim>& state, double time, double dt);

/// Sets the momentum balance's velocities, and tells the reaction Σ m_i (v − v_free)/Δt and its work.
/// @param time end of the step [s]
template <int Dim>
void hold_nodes(State<Dim>& state, double time, double dt);

/// Sets velocities alone (after a remap, or before a USF stress update).
template <int Dim>
void hold_velocities(State<Dim>& state, double time);

} // namespace riedel
