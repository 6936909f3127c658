#include "core/step/rotation.hpp"

#include <Eigen/LU>

namespace riedel {

Mat<3> rotation_of(const Mat<3>& L, double dt) {
  const Mat<3> half = 0.25 * dt * (L - L.transpose());
  return (Mat<3>::Identity() - half).inverse() * (Mat<3>::Identity() + half);
}

Sym<double> rotated(const Sym<double>& a, const Mat<3>& Q) { return to_sym(Q * to_matrix(a) * Q.transpose()); }

} // namespace riedel
