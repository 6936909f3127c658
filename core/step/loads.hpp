/// External forces: tractions on surface points, body forces, and the work of loads. Gravity and the virtual stress are
/// part of the transfer itself.
#pragma once

#include "core/step/model.hpp"

namespace riedel {

/// f_i += Σ_p ∫ N_i t da over the outer face of each loaded point, with da from F by Nanson's formula and multilinear
/// hats N_i for every scheme, exact or, for schemes that do so, interpolated between the face's corners. Domains that
/// fill the material up to a straight edge are then in equilibrium with a uniform stress, wherever in the cell it lies.
template <int Dim>
void add_surface_tractions(State<Dim>& state, const Model<Dim>& model);

/// f_i += Σ_p N_ip m_p b_p. To be called after the first sums of the step, when points are in the order of their slabs.
template <int Dim>
void add_body_forces(State<Dim>& state, const Model<Dim>& model);

/// Both.
template <int Dim>
void add_loads(State<Dim>& state, const Model<Dim>& model);

/// Work of the surface tractions over one step, with the points' velocities [J or J/m].
template <int Dim>
double surface_work(const State<Dim>& state, const Model<Dim>& model, double dt);

/// The same for the body forces.
template <int Dim>
double body_work(const State<Dim>& state, const Model<Dim>& model, double dt);

} // namespace riedel
