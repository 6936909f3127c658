/// Motions that boundaries impose on nodes, and the forces that this takes.
#pragma once

#include "core/interface/shape_function.hpp"
#include "core/step/state.hpp"

#include <optional>

namespace riedel {

/// A motion that grows from node row to node row along `axis`: 0 in `fixed_row`, 1 in `moving_row`, and beyond, too.
struct LinearMotion {
  int axis = 0;
  Index fixed_row = 0, moving_row = 1;
};

/// One velocity component imposed on a box of nodes: a fixed side, a driven platen, a single pinned node, or a platen
/// that is free to move as one.
template <int Dim>
struct NodeCondition {
  std::string name;
  Counts<Dim> first{}, last{};                   ///< corners of the box of nodes, both included
  int axis = 0;                                  ///< the component held
  std::function<double(double time)> velocity{}; ///< [m/s]; none: free, one motion for all nodes, by their momentum
  std::optional<LinearMotion> linear{};          ///< the nodes' shares in the velocity; none: all move alike
  std::optional<std::array<Counts<Dim>, 2>> but_for{}; ///< corners of a box of nodes inside that is left out
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

/// Sets the momentum balance's velocities v_i = s_i v, s_i being the nodes' shares, and tells the reaction
/// Σ m_i s_i (v_i − v_free,i)/Δt and its work. Where v is not given it is Σ m_i s_i v_free,i / Σ m_i s_i², for which
/// the reaction vanishes.
/// @param time end of the step [s]
template <int Dim>
void hold_nodes(State<Dim>& state, double time, double dt);

/// Sets velocities alone (after a remap, or before a USF stress update).
template <int Dim>
void hold_velocities(State<Dim>& state, double time);

} // namespace riedel
