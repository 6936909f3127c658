#include "core/step/kinematics.hpp"

#include "core/base/parallel.hpp"

#include <Eigen/LU>

namespace riedel {

namespace {

template <int Dim>
Mat<Dim> velocity_gradient(const State<Dim>& state, const Body<Dim>& body, Index p) {
  const StencilGroup<Dim>& group = body.stencils.group_of(p);
  const int lane = p % pack_size;
  Mat<Dim> L = Mat<Dim>::Zero();
  for (int entry = 0; entry < group.count; ++entry) {
    const Vec<Dim>& v = state.nodes.motion[group.node[entry * pack_size + lane]].velocity;
    for (int j = 0; j < Dim; ++j) L.col(j) += group.slope[(entry * Dim + j) * pack_size + lane] * v;
  }
  return L;
}

template <int Dim>
void deform(Points<Dim>& points, Index p, const Mat<Dim>& L, double dt) {
  const Mat<Dim> F = points.deformation_gradient_of(p) + dt * L * points.deformation_gradient_of(p);
  for (int i = 0; i < Dim; ++i)
    for (int j = 0; j < Dim; ++j) {
      points.velocity_gradient[i * Dim + j][p] = L(i, j);
      points.deformation_gradient[i * Dim + j][p] = F(i, j);
    }
  points.volume[0][p] = points.initial_volume[0][p] * F.determinant();

  const Mat<Dim> D = 0.5 * (L + L.transpose());
  const double squared = D.squaredNorm(), volumetric = square(D.trace()) / 3.0; // ‖dev D‖² = ‖D‖² − (tr D)²/3
  points.rate_norm[0][p] = std::sqrt(squared);
  points.shear_strain[0][p] += dt * std::sqrt(2.0 * std::max(squared - volumetric, 0.0));
}

} // namespace

template <int Dim>
void update_kinematics(State<Dim>& state, double dt) {
  for (Body<Dim>& body : state.bodies)
    for_each_block(body.points.size(), [&](Range block) {
      for (Index p = block.begin; p < block.end; ++p) deform(body.points, p, velocity_gradient(state, body, p), dt);
    });
}

template void update_kinematics<2>(State<2>&, double);
template void update_kinematics<3>(State<3>&, double);

} // namespace riedel
