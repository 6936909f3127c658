/// The plane strain compression test as a simulation: geometry, grid, initial state, boundaries.
#pragma once

#include "apps/biaxial/geometry.hpp"
#include "core/interface/catalogue.hpp"
#include "core/step/simulation.hpp"

namespace riedel {

/// Composes the biaxial test from a validated case (docs/theory/biaxial.md). Node conditions are called "bottom", "top"
/// and "pin", in three dimensions also "back" and "front"; with rigid points "top" is a rigid body. Points are numbered
/// row by row, and layer by layer of the depth.
template <int Dim = 2>
Simulation<Dim> make_biaxial(const BiaxialCase& values, const Catalogue& catalogue);

/// Applies the keys of the step. In a slow test the strain between two crossings of a wave is small, and the noise of
/// points that cross cells, which depends on their displacement, is larger relative to ‖D‖. So "auto" damps a slower
/// test more, below a strain of 7·10⁻⁵ in the time that a wave takes across the width.
template <int Dim>
void set_biaxial_step(Model<Dim>& model, const BiaxialCase& values, const Catalogue& catalogue, const Material& law);

/// Vertical force on the top platen, compression positive, including the part that balances the confining pressure
/// [N/m].
template <int Dim>
double platen_force(const Simulation<Dim>& simulation, const BiaxialCase& values);
/// The same times the last time step [N s/m].
template <int Dim>
double platen_impulse(const Simulation<Dim>& simulation, const BiaxialCase& values);

/// φ_mob = asin((σ1 − σ3)/(σ1 + σ3)) with σ1 = force/b0 and σ3 the confining pressure [deg].
double mobilised_angle(double force, const BiaxialCase& values);

/// The same with the true stress: σ1 acts on the present width. Only the force in excess of the confining pressure is
/// divided by it, because `force` contains the pressure on the initial width [deg].
double true_angle(double force, double width, const BiaxialCase& values);

/// Width of the specimen at its ends, from the first to the last point of the rows at both platens: the width that
/// carries the force. The usual laboratory correction, volume over height, would count the offset of the blocks beside
/// a band as width [m].
template <int Dim>
double present_width(const Points<Dim>& points, const BiaxialCase& values);

} // namespace riedel
