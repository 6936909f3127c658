/// Finds the points on the grid: their stencils, and an order in which threads do not meet.
#pragma once

#include "core/step/model.hpp"

namespace riedel {

/// N_ip and ∇N_ip of all points. Sorts a body's points anew when some have moved so far that two slabs of one parity
/// would touch a common node. Throws RunError naming the first point whose support leaves the grid.
template <int Dim>
void locate_points(State<Dim>& state, const Model<Dim>& model);

/// Sizes stencils and nodes for the state's points and grid, and sorts the points.
template <int Dim>
void prepare_points(State<Dim>& state, const Model<Dim>& model);

} // namespace riedel
