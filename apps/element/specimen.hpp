/// The specimen of an element test as a simulation: a cube (a square) between smooth plates.
#pragma once

#include "apps/element/case.hpp"
#include "core/case/step_keys.hpp"
#include "core/interface/catalogue.hpp"
#include "core/step/simulation.hpp"
#include "materials/element/material_point.hpp"

namespace riedel {

/// PIC damps the outward motion of the sides: 0.98 per step causes an error of 0.07 degrees at the peak in a single
/// cell, this value, about 0.995, one of 0.02. No stress filter: nodes that move in proportion leave nothing
/// unresolved.
constexpr StepDefaults element_step_defaults{.damping = 0.01, .stress_filter = 0.0, .slow_damp_more = false};

/// Composes a named test (docs/theory/element_tests.md). The axes are those of the test: 1 is the
/// direction of loading; in the shear test 1 is the direction of shear and 2 the normal to the sheared planes.
/// @param stress at the start, tension positive [Pa]
/// @throws InputError if the test cannot be run in this way
template <int Dim>
Simulation<Dim> make_element(const ElementCase& given, const Catalogue& catalogue, const Sym<double>& stress);

/// The specimen as one point: F is the mean over its initial volume, stress and state over its present one. Called
/// after every step, because natural shear is accumulated.
template <int Dim>
void follow_element(MaterialPoint& mean, const Simulation<Dim>& simulation);

/// Largest deviation of a point's stress from the mean, relative to the norm of the mean [-].
template <int Dim>
double stress_spread(const Simulation<Dim>& simulation, const Sym<double>& mean);

} // namespace riedel
