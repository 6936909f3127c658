/// Supports, drive and lateral pressure of the biaxial specimen.
#pragma once

#include "apps/biaxial/geometry.hpp"
#include "core/step/model.hpp"

namespace riedel {

/// Smooth platens, of which the upper one moves, and in three dimensions smooth walls. For a rotated specimen both
/// platens, and the point that fixes the middle of the lower one laterally, are rigid bodies.
/// @param model receives conditions and, for a platen that the grid follows, the moving grid
/// @param state receives the rigid bodies
template <int Dim>
void set_platens(Model<Dim>& model, State<Dim>& state, const SpecimenGeometry<Dim>& specimen,
                 const BiaxialCase& values);

/// The lateral pressure, as a virtual stress or on the points at the sides.
template <int Dim>
void set_lateral_pressure(Model<Dim>& model, const Points<Dim>& points, const SpecimenGeometry<Dim>& specimen,
                          const BiaxialCase& values);

} // namespace riedel
