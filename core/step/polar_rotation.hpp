/// Rotation of stress over a step with the R of the polar decomposition F = R U, whose spin Ω = Ṙ Rᵀ is that of the
/// rate of A. E. Green & P. M. Naghdi (1965), Arch. Rational Mech. Anal. 18, 251–281. Equation numbers are those of
/// docs/theory/mpm_step.md.
#pragma once

#include "core/step/rotation.hpp"

namespace riedel {

/// F at the start of a step, up to a positive factor: adj(I + Δt L) F. @param F at its end
template <std::size_t Dim>
auto scaled_start(const std::array<std::array<Pack, Dim>, Dim>& F, std::array<std::array<Pack, Dim>, Dim> L,
                  double dt) {
  for (std::size_t i = 0; i < Dim; ++i)
    for (std::size_t j = 0; j < Dim; ++j) L[i][j] = Pack(i == j ? 1.0 : 0.0) + Pack(dt) * L[i][j];
  return transposed_times(cofactor(L), F);
}

/// R_{n+1} R_nᵀ (8) in the plane, where tan β = (F_21 − F_12)/(F_11 + F_22).   @param F at the end of the step
inline PlaneRotation polar_rotation(const PackMatrix<2>& F, const PackMatrix<2>& L, double dt) {
  const PackMatrix<2> G = scaled_start(F, L, dt);
  const Pack a = F[0][0] + F[1][1], b = F[0][1] - F[1][0], a_0 = G[0][0] + G[1][1], b_0 = G[0][1] - G[1][0];
  const Pack x = a * a_0 + b * b_0, y = b * a_0 - a * b_0;
  const Pack scale = Pack(1.0) / max(x * x + y * y, Pack(1e-300)); // zero in lanes past the last point
  return {.cos_2 = (x * x - y * y) * scale, .sin_2 = Pack(2.0) * x * y * scale};
}

/// R of F = R U, det F > 0, by Newton's iteration X ← (X + X⁻ᵀ)/2: N. J. Higham (1986), SIAM J. Sci. Stat. Comput. 7,
/// 1160–1174. The number of correct digits doubles in each iteration, once as many iterations are done as the largest
/// stretch has powers of two. Returns I if det F is not positive.
inline PackMatrix<3> polar_factor(const PackMatrix<3>& F) {
  constexpr int max_rounds = 30;
  constexpr double enough = 1e-18; // of a squared change: the remaining error is its square
  PackMatrix<3> X = F;
  Pack det = determinant(X);
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) X[i][j] = select(det > Pack(0.0), X[i][j], Pack(i == j ? 1.0 : 0.0));
  for (int round = 0; round < max_rounds; ++round) {
    const PackMatrix<3> C = cofactor(X);
    const Pack half_per_det = Pack(0.5) / determinant(X);
    Pack change(0.0);
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j) {
        const Pack next = Pack(0.5) * X[i][j] + half_per_det * C[i][j], step = next - X[i][j];
        X[i][j] = next;
        change += step * step;
      }
    if (all(change <= Pack(enough))) break;
  }
  return X;
}

/// R_{n+1} R_nᵀ (8) in space.   @param F at the end of the step
inline SpaceRotation polar_rotation(const PackMatrix<3>& F, const PackMatrix<3>& L, double dt) {
  const PackMatrix<3> R = polar_factor(F), R_0 = polar_factor(scaled_start(F, L, dt));
  SpaceRotation Q;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) Q[i][j] = R[i][0] * R_0[j][0] + R[i][1] * R_0[j][1] + R[i][2] * R_0[j][2];
  return Q;
}

} // namespace riedel
