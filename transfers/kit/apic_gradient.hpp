/// The gradient that APIC stores: see transfers/apic.hpp.
#pragma once

#include "core/base/pack_matrix.hpp"
#include "core/step/kernels/gather.hpp"

namespace riedel {

/// A point stores B_p = Σ_i N_ip v_i ⊗ (x_i − x_p) [m²/s], its share of the angular momentum, from the stencil that
/// gave it its velocity, and passes to its nodes the gradient C_p = B_p D_p⁻¹ with D_p of the present stencil.
template <int Dim>
struct ApicGradient {
  static constexpr bool keeps_gradient = false;

  /// Σ_i N_ip v_i and B_p of eight points. @return B_p by columns
  static PackMatrix<Dim> gather(const StencilEntries<Dim>& /*stencil*/, const StencilEntries<Dim>& moments,
                                const Nodes<Dim>& nodes, Gathered<Dim>& sum) {
    riedel::gather<Use::both>(moments, nodes.motion, sum);
    return sum.gradient.vectors();
  }

  /// C_p [1/s]
  static PackMatrix<Dim> gradient(const PackMatrix<Dim>& B, const PackMatrix<Dim>& D) {
    const PackMatrix<Dim> cofactors = cofactor(D);                              // D is symmetric
    const Pack per_determinant = Pack(1.0) / max(determinant(D), Pack(1e-300)); // for lost or unused lanes
    PackMatrix<Dim> C;
    for (int i = 0; i < Dim; ++i)
      for (int j = 0; j < Dim; ++j) {
        C[i][j] = B[i][0] * cofactors[0][j];
        for (int k = 1; k < Dim; ++k) C[i][j] += B[i][k] * cofactors[k][j];
        C[i][j] *= per_determinant;
      }
    return C;
  }
};

} // namespace riedel
