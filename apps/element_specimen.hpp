/// The specimen of an element test as a simulation: a cube (a square) between smooth plates.
#pragma once

#include "core/interface/catalogue.hpp"
#include "core/step/simulation.hpp"
#include "materials/law_point.hpp"

namespace riedel {

/// Two for the tests in plane strain and three for the triaxial one, unless the case says which.
int dimensions_of_element(const Values& values);

/// Composes a named test from a validated case (docs/theory/element_tests.md). The axes are those of the test: 1 is the
/// direction of loading; in the shear test 1 is the direction of shear and 2 the normal to the sheared planes.
/// @param stress at the start, tension positive [Pa]
/// @throws InputError if the test cannot be carried out so
template <int Dim>
Simulation<Dim> make_element(const Values& values, const Catalogue& catalogue, const Sym<double>& stress);

/// The specimen seen as one point: F is the mean over its first volume, stress and state over its present one. Called
/// after every step, because natural shear adds up.
template <int Dim>
void follow_element(LawPoint& mean, const Simulation<Dim>& simulation);

/// Greatest distance of a point's stress from the mean, over the mean's size [-].
template <int Dim>
double stress_spread(const Simulation<Dim>& simulation, const Sym<double>& mean);

} // namespace riedel
