#include "core/step/kinematics.hpp"

#include "core/base/pack.hpp"
#include "core/base/parallel.hpp"

namespace riedel {

namespace {

template <class Real, int Dim>
using Square = std::array<std::array<Real, Dim>, Dim>;

template <int Dim>
void gather_velocity_gradient(const State<Dim>& state, Body<Dim>& body, Index p) {
  const StencilGroup<Dim>& group = body.stencils.group_of(p);
  const int lane = p % pack_size;
  Mat<Dim> L = Mat<Dim>::Zero();
  for (int entry = 0; entry < group.count; ++entry) {
    const Vec<Dim>& v = state.nodes.motion[group.node[entry * pack_size + lane]].velocity;
    for (int j = 0; j < Dim; ++j) L.col(j) += group.slope[(entry * Dim + j) * pack_size + lane] * v;
  }
  for (int i = 0; i < Dim; ++i)
    for (int j = 0; j < Dim; ++j) body.points.velocity_gradient[i * Dim + j][p] = L(i, j);
}

template <int Dim>
Square<Pack, Dim> load(const Columns& field, Index p) {
  Square<Pack, Dim> m;
  for (int i = 0; i < Dim; ++i)
    for (int j = 0; j < Dim; ++j) m[i][j] = Pack::load(field[i * Dim + j] + p);
  return m;
}

Pack determinant(const Square<Pack, 2>& a) { return a[0][0] * a[1][1] - a[0][1] * a[1][0]; }
Pack determinant(const Square<Pack, 3>& a) {
  return a[0][0] * (a[1][1] * a[2][2] - a[1][2] * a[2][1]) - a[0][1] * (a[1][0] * a[2][2] - a[1][2] * a[2][0]) +
         a[0][2] * (a[1][0] * a[2][1] - a[1][1] * a[2][0]);
}

/// Eight points at once; columns are padded to whole packs.
template <int Dim>
void deform(Points<Dim>& points, Index p, double dt) {
  const Square<Pack, Dim> L = load<Dim>(points.velocity_gradient, p);
  const Square<Pack, Dim> old = load<Dim>(points.deformation_gradient, p);
  Square<Pack, Dim> F = old;
  Pack squared(0.0), trace(0.0);
  for (int i = 0; i < Dim; ++i) {
    trace += L[i][i];
    for (int j = 0; j < Dim; ++j) {
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

} // namespace

template <int Dim>
void update_kinematics(State<Dim>& state, double dt) {
  for (Body<Dim>& body : state.bodies)
    for_each_block(body.points.size(), [&](Range block) {
      for (Index p = block.begin; p < block.end; ++p) gather_velocity_gradient(state, body, p);
      for (Index p = block.begin; p < block.end; p += pack_size) deform(body.points, p, dt);
    });
}

template void update_kinematics<2>(State<2>&, double);
template void update_kinematics<3>(State<3>&, double);

} // namespace riedel
