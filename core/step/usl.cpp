#include "core/step/usl.hpp"

#include "core/step/boundary.hpp"
#include "core/step/grid_to_points.hpp"
#include "core/step/loads.hpp"
#include "core/step/locking.hpp"
#include "core/step/points_to_grid.hpp"
#include "core/step/stress_filter.hpp"
#include "core/step/stress_update.hpp"

namespace riedel {

template <int Dim>
void usl_step(State<Dim>& state, const Model<Dim>& model, double dt) {
  const VelocityTransfer<Dim>& transfer = *model.transfer;
  transfer.points_to_grid(state, model);     // m_i, (mv)_i, f_i = −Σ_p V_p (σ_p + p I) ∇N_ip
  add_loads(state, model);                   // f_i of surface tractions and body forces
  find_cells(state, model);                  // F-bar only, before the points move
  filter_stresses(state, model, dt);         // every k-th step, if on: damps null-space parts of σ_p and ln J_p
  advance_momentum(state, model, dt);        // a_i = f_i/m_i + g, v_i = (mv)_i/m_i + a_i Δt
  apply_boundaries(state, model, dt);        // boundaries, reactions
  transfer.grid_to_points(state, model, dt); // v_p, x_p, L_p = Σ_i v_i ⊗ ∇N_ip, F_p, V_p
  average_dilatation(state, model, dt);      // F-bar only: equal tr L_p in a cell, then F_p, V_p
  update_stress(state, model, dt);           // d*, rotation, law
}

template void usl_step<2>(State<2>&, const Model<2>&, double);
template void usl_step<3>(State<3>&, const Model<3>&, double);

} // namespace riedel
