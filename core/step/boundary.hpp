/// The conditions of a model, one after the other.
#pragma once

#include "core/step/model.hpp"

namespace riedel {

/// Has every condition find its nodes, and tells the grid its walls: of two on one side, the inner one.
template <int Dim>
void bind_boundaries(State<Dim>& state, const Model<Dim>& model);

/// At the start of a step: nodes of conditions that move. Throws RunError.
template <int Dim>
void follow_boundaries(const State<Dim>& state, const Model<Dim>& model);

/// Before the momentum balance gives the nodes new velocities.
template <int Dim>
void remember_velocities(const State<Dim>& state, const Model<Dim>& model);

/// Changes the momentum balance's velocities and accelerations, and adds up what it took.
template <int Dim>
void apply_boundaries(State<Dim>& state, const Model<Dim>& model, double dt);

/// Sets velocities alone (after a remap, or before a USF stress update).
/// @param time that they are those of [s]
template <int Dim>
void apply_boundary_velocities(State<Dim>& state, const Model<Dim>& model, double time);

/// At the end of a step, which is at `time`.
template <int Dim>
void move_boundaries(const Model<Dim>& model, double time, double dt);

} // namespace riedel
