/// The F-bar remedy for volumetric locking: all points of a cell dilate equally (docs/theory/mpm_step.md).
#pragma once

#include "core/step/model.hpp"

namespace riedel {

/// Stores the cells of all points, for `average_dilatation`. Called after the points are sorted and before they move;
/// does nothing without F-bar.
template <int Dim>
void find_cells(State<Dim>& state, const Model<Dim>& model);

/// L_p ← L_p + (⟨tr L⟩ − tr L_p)/Dim I with the mean ⟨tr L⟩ = Σ V_p tr L_p / Σ V_p over the points of one body in one
/// cell; then F_p, V_p, ‖D_p‖ and the shear strain, which the kinematics left open. Does nothing without F-bar.
template <int Dim>
void average_dilatation(State<Dim>& state, const Model<Dim>& model, double dt);

} // namespace riedel
