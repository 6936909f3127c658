/// The motion of a block of points over a step, for a law that follows it.
#pragma once

#include "core/interface/material.hpp"
#include "core/state/points.hpp"
#include "core/step/rotation.hpp"

#include <Eigen/LU>

namespace riedel {

/// Q of eight points, row by row, from the cosine and sine of twice its angle.
inline PackMatrix<2> matrix_of(const PlaneRotation& Q) {
  const Pack c = sqrt(Pack(0.5) * (Pack(1.0) + Q.cos_2)), s = Q.sin_2 / (c + c);
  return {{{c, s}, {-s, c}}};
}
inline const PackMatrix<3>& matrix_of(const SpaceRotation& Q) { return Q; }

/// Up to `maximum` points at a time; lives on the stack. A motion in the plane leaves the third axis unchanged.
template <int Dim, Index maximum>
class BlockMotion {
public:
  BlockMotion() {
    for (std::size_t c = 0; c < 9; ++c) {
      const std::size_t i = c / 3, j = c % 3;
      if (i < Dim && j < Dim) {
        motion_.gradient_before[c] = before_[i * Dim + j].data();
        motion_.rotation[c] = rotation_[i * Dim + j].data();
      } else {
        motion_.velocity_gradient[c] = none_.data();
        motion_.deformation_gradient[c] = motion_.gradient_before[c] = motion_.rotation[c] =
            i == j ? one_.data() : none_.data();
      }
    }
  }

  /// @param rotation_of maps the first of eight points to their Q
  template <class Rotation>
  void follow(const Points<Dim>& points, Range range, double dt, const Rotation& rotation_of) {
    for (int i = 0; i < Dim; ++i)
      for (int j = 0; j < Dim; ++j) {
        const auto c = static_cast<std::size_t>(i * 3 + j);
        motion_.velocity_gradient[c] = points.velocity_gradient[i * Dim + j] + range.begin;
        motion_.deformation_gradient[c] = points.deformation_gradient[i * Dim + j] + range.begin;
      }
    for (Index p = range.begin; p < range.end; ++p) find_gradient_before(points, p, p - range.begin, dt);
    for (Index p = range.begin; p < range.end; p += pack_size) {
      const PackMatrix<Dim> Q = matrix_of(rotation_of(p));
      for (std::size_t i = 0; i < Dim; ++i)
        for (std::size_t j = 0; j < Dim; ++j) Q[i][j].store(rotation_[i * Dim + j].data() + (p - range.begin));
    }
  }

  [[nodiscard]] const Motion& motion() const { return motion_; }

private:
  using Column = std::array<double, maximum>;

  /// (I + Δt L)⁻¹ F
  void find_gradient_before(const Points<Dim>& points, Index p, Index place, double dt) {
    Mat<Dim> F, step;
    for (int i = 0; i < Dim; ++i)
      for (int j = 0; j < Dim; ++j) {
        F(i, j) = points.deformation_gradient[i * Dim + j][p];
        step(i, j) = (i == j ? 1.0 : 0.0) + dt * points.velocity_gradient[i * Dim + j][p];
      }
    const Mat<Dim> before = step.inverse() * F;
    for (int i = 0; i < Dim; ++i)
      for (int j = 0; j < Dim; ++j)
        before_[static_cast<std::size_t>(i * Dim + j)][static_cast<std::size_t>(place)] = before(i, j);
  }

  static Column filled(double x) {
    Column all;
    all.fill(x);
    return all;
  }
  inline static const Column none_ = filled(0.0), one_ = filled(1.0);
  std::array<Column, Dim * Dim> before_, rotation_;
  Motion motion_;
};

} // namespace riedel
