/// Update of eight points from the motion of the grid. Columns are padded to whole packs, so extra lanes are harmless.
#pragma once

#include "core/base/pack_matrix.hpp"
#include "core/state/points.hpp"
#include "core/step/kernels/gather.hpp"
#include "core/step/model.hpp"

namespace riedel {

/// v_p after the step, and the points' displacement Δt Σ N_ip v_i.
template <int Dim>
struct NewMotion {
  std::array<Pack, Dim> velocity, displacement_increment;
};

/// v_p ← flip (v_p + Δt Σ N_ip a_i) + (1 − flip) Σ N_ip v_i.
template <int Dim>
NewMotion<Dim> new_motion(const Gathered<Dim>& sum, const Points<Dim>& points, Index p, double flip, double dt) {
  NewMotion<Dim> motion;
  const std::array<Pack, 4> first = sum.motion.front().columns(), second = sum.motion.back().columns();
  for (int i = 0; i < Dim; ++i) {
    const Pack v = first[i], a = second[Dim == 2 ? 2 + i : i]; // in the plane one row holds both
    motion.velocity[i] = Pack(flip) * (Pack::load(points.velocity[i] + p) + Pack(dt) * a) + Pack(1.0 - flip) * v;
    motion.displacement_increment[i] = Pack(dt) * v;
  }
  return motion;
}

/// x_p ← x_p + displacement_increment.
template <int Dim>
void move(Points<Dim>& points, Index p, const std::type_identity_t<std::array<Pack, Dim>>& displacement_increment) {
  for (int a = 0; a < Dim; ++a)
    (Pack::load(points.position[a] + p) + displacement_increment[a]).store(points.position[a] + p);
}

/// v_p and x_p after the step.
template <int Dim>
void take_up(const NewMotion<Dim>& motion, Points<Dim>& points, Index p) {
  for (int a = 0; a < Dim; ++a) motion.velocity[a].store(points.velocity[a] + p);
  move(points, p, motion.displacement_increment);
}

/// F_p ← (I + L_p Δt) F_p, V_p = V_p0 det F_p, ‖D_p‖, and the accumulated shear strain.
template <int Dim>
void strain(const std::type_identity_t<PackMatrix<Dim>>& L, Points<Dim>& points, Index p, double dt) {
  const PackMatrix<Dim> old = load_matrix<Dim>(points.deformation_gradient, p);
  PackMatrix<Dim> F;
  Pack squared(0.0), trace(0.0);
  for (int i = 0; i < Dim; ++i) {
    trace += L[i][i];
    for (int j = 0; j < Dim; ++j) {
      F[i][j] = old[i][j];
      for (int k = 0; k < Dim; ++k) F[i][j] += Pack(dt) * L[i][k] * old[k][j];
      F[i][j].store(points.deformation_gradient[i * Dim + j] + p);
      const Pack D = Pack(0.5) * (L[i][j] + L[j][i]);
      squared += D * D;
    }
  }
  (Pack::load(points.initial_volume[0] + p) * determinant(F)).store(points.volume[0] + p);
  sqrt(squared).store(points.rate_norm[0] + p);
  const Pack deviatoric = max(squared - trace * trace * Pack(1.0 / 3.0), Pack(0.0)); // ‖dev D‖²
  double* const shear = points.shear_strain[0] + p;
  (Pack::load(shear) + Pack(dt) * sqrt(deviatoric + deviatoric)).store(shear);
}

/// Adds the stress filter's term to the trace of L_p. The third axis of plane strain is left out.
template <int Dim>
void add_expansion(const Points<Dim>& points, Index p, const StressFilter& filter, PackMatrix<Dim>& L) {
  if (points.expansion.components() == 0) return;
  const int axes = std::min(Dim, filter.volume_axes);
  const Pack share = Pack(1.0 / axes) * Pack::load(points.expansion[0] + p);
  for (int i = 0; i < axes; ++i) L[i][i] += share;
}

/// L_p = Σ_i v_i ⊗ ∇N_ip, and the strains from it, unless the locking remedy still changes L_p.
template <int Dim>
void deform(const Gathered<Dim>& sum, Points<Dim>& points, Index p, const Model<Dim>& model, double dt) {
  PackMatrix<Dim> L;
  const PackMatrix<Dim> gradient = sum.gradient.vectors();
  for (int i = 0; i < Dim; ++i)
    for (int j = 0; j < Dim; ++j) L[i][j] = gradient[j][i];
  const bool at_once = model.locking == Locking::none;
  if (at_once) add_expansion<Dim>(points, p, model.stress_filter, L);
  for (int i = 0; i < Dim; ++i)
    for (int j = 0; j < Dim; ++j) L[i][j].store(points.velocity_gradient[i * Dim + j] + p);
  if (at_once) strain(L, points, p, dt);
}

} // namespace riedel
