/// Forces from outside: pressure on surface points, body forces, and the work of loads. Gravity and the virtual stress
/// act in the transfer itself.
#pragma once

#include "core/step/model.hpp"

namespace riedel {

/// f_i += Σ_p N_i(x_f) f_p with f_p = −pressure J F⁻ᵀ A_p at the outer face x_f of each loaded point.
template <int Dim>
void add_surface_pressures(State<Dim>& state, const Model<Dim>& model);

/// f_i += Σ_p N_ip m_p b_p. Once the sums of the step have begun, so that points are in the order of their slabs.
template <int Dim>
void add_body_forces(State<Dim>& state, const Model<Dim>& model);

/// Power of the surface pressures over one step, with the points' velocities [J or J/m].
template <int Dim>
double surface_work(const State<Dim>& state, const Model<Dim>& model, double dt);

/// The same of the body forces.
template <int Dim>
double body_work(const State<Dim>& state, const Model<Dim>& model, double dt);

} // namespace riedel
