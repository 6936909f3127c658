/// Forces from outside: tractions on surface points, body forces, and the work of loads. Gravity and the virtual stress
/// act in the transfer itself.
#pragma once

#include "core/step/model.hpp"

namespace riedel {

/// f_i += Σ_p ∫ N_i t da over the outer face of each loaded point, with da from F by Nanson's formula and multilinear
/// hats N_i whatever the scheme, as they are or, for a scheme that does so, between the face's corners. Domains that
/// fill the material up to a straight edge are then in equilibrium with a uniform stress, wherever in a cell the edge
/// lies.
template <int Dim>
void add_surface_tractions(State<Dim>& state, const Model<Dim>& model);

/// f_i += Σ_p N_ip m_p b_p. Once the sums of the step have begun, so that points are in the order of their slabs.
template <int Dim>
void add_body_forces(State<Dim>& state, const Model<Dim>& model);

/// Both.
template <int Dim>
void add_loads(State<Dim>& state, const Model<Dim>& model);

/// Power of the surface tractions over one step, with the points' velocities [J or J/m].
template <int Dim>
double surface_work(const State<Dim>& state, const Model<Dim>& model, double dt);

/// The same of the body forces.
template <int Dim>
double body_work(const State<Dim>& state, const Model<Dim>& model, double dt);

} // namespace riedel
