#include "core/step/usf.hpp"

#include "core/step/boundary.hpp"
#include "core/step/grid_to_points.hpp"
#include "core/step/loads.hpp"
#include "core/step/locate.hpp"
#include "core/step/locking.hpp"
#include "core/step/points_to_grid.hpp"
#include "core/step/stress_filter.hpp"
#include "core/step/stress_update.hpp"

namespace riedel {

template <int Dim>
void usf_step(State<Dim>& state, const Model<Dim>& model, double dt) {
  const VelocityTransfer<Dim>& transfer = *model.transfer;
  keep_stencils(state, model);                  // domains deform within the step, weights must not
  transfer.map_mass_and_momentum(state, model); // m_i, (mv)_i
  divide_momentum(state, model);                // v_i = (mv)_i/m_i
  find_cells(state, model);                     // F-bar only
  filter_stresses(state, model, dt);            // every k-th step, if on: damps null-space parts of σ_p and ln J_p
  apply_boundary_velocities(state, model, state.time);
  const double power_before = state.node_power.end; // of the previous forces with the velocities of these strains
  update_kinematics(state, model, dt);              // L_p = Σ_i v_i ⊗ ∇N_ip, F_p, V_p
  average_dilatation(state, model, dt);             // F-bar only: equal tr L_p in a cell, then F_p, V_p
  update_stress(state, model, dt);                  // d*, rotation, law
  map_forces(state, model);                         // f_i = −Σ_p V_p (σ_p + p I) ∇N_ip
  add_loads(state, model);                          // f_i of surface tractions and body forces
  advance_momentum(state, model, dt);               // a_i = f_i/m_i + g, v_i = (mv)_i/m_i + a_i Δt
  apply_boundaries(state, model, dt);               // boundaries, reactions
  state.node_power.end = power_before;
  transfer.move_points(state, model, dt); // v_p, x_p
}

template void usf_step<2>(State<2>&, const Model<2>&, double);
template void usf_step<3>(State<3>&, const Model<3>&, double);

} // namespace riedel
