/// The specimen of an element test as a simulation: a cube (a square) between smooth plates.
#pragma once

#include "apps/element/case.hpp"
#include "core/case/step_keys.hpp"
#include "core/interface/catalogue.hpp"
#include "core/step/simulation.hpp"
#include "materials/element/material_point.hpp"

namespace riedel {

/// PIC drags on the sides as they move out: 0.98 per step leaves 0.07 degrees at the peak in a single cell, and this,
/// some 0.995, 0.02. Where all nodes move in proportion, there is nothing that no node sees.
constexpr StepDefaults element_step_defaults{.damping = 0.01, .stress_filter = 0.0, .slow_damp_more = false};

/// Composes a named test (docs/theory/element_tests.md). The axes are those of the test: 1 is the
/// direction of loading; in the shear test 1 is the direction of shear and 2 the normal to the sheared planes.
/// @param stress at the start, tension positive [Pa]
/// @throws InputError if the test cannot be carried out so
template <int Dim>
Simulation<Dim> make_element(const ElementCase& given, const Catalogue& catalogue, const Sym<double>& stress);

/// The specimen seen as one point: F is the mean over its first volume, stress and state over its present one. Called
/// after every step, because natural shear adds up.
template <int Dim>
void follow_element(MaterialPoint& mean, const Simulation<Dim>& simulation);

/// Greatest distance of a point's stress from the mean, over the mean's size [-].
template <int Dim>
double stress_spread(const Simulation<Dim>& simulation, const Sym<double>& mean);

} // namespace riedel
