/// The conditions of a model, one after another.
#pragma once

#include "core/step/model.hpp"

namespace riedel {

/// Lets every condition find its nodes, and sets the walls of the grid: of two on one side, the inner one.
template <int Dim>
void bind_boundaries(State<Dim>& state, const Model<Dim>& model);

/// At the start of a step: updates the nodes of moving conditions. Throws RunError.
template <int Dim>
void follow_boundaries(const State<Dim>& state, const Model<Dim>& model);

/// Before the momentum balance gives the nodes new velocities.
template <int Dim>
void remember_velocities(const State<Dim>& state, const Model<Dim>& model);

/// Changes velocities and accelerations after the momentum balance, and sums the work of the conditions.
template <int Dim>
void apply_boundaries(State<Dim>& state, const Model<Dim>& model, double dt);

/// Sets velocities only (after a remap, or before a USF stress update).
/// @param time to which they belong [s]
template <int Dim>
void apply_boundary_velocities(State<Dim>& state, const Model<Dim>& model, double time);

/// At the end of a step, at `time`.
template <int Dim>
void move_boundaries(const Model<Dim>& model, double time, double dt);

} // namespace riedel
