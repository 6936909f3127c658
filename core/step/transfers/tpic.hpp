/// The Taylor particle-in-cell transfer, TPIC: Nakamura, Matsumura & Mizutani (2023), Comput. Methods Appl. Mech.
/// Engrg. 403, 115720.
#pragma once

#include "core/step/kernels/gather.hpp"
#include "core/step/pack_matrix.hpp"

namespace riedel {

/// A point keeps the gradient C_p = Σ_i v_i ⊗ ∇N_ip [1/s] of the velocities it took its own from, and gives its nodes
/// Taylor's series about it.
struct Tpic {
  static constexpr bool keeps_gradient = true;

  /// Σ_i N_ip v_i and C_p of eight points. @return C_p by columns
  template <int Dim>
  static PackMatrix<Dim> gather_slope(const StencilEntries<Dim>& stencil, const StencilEntries<Dim>& /*moments*/,
                                      const Nodes<Dim>& nodes, Gathered<Dim>& sum) {
    gather<Use::both>(stencil, nodes.motion, sum);
    return sum.gradient.vectors();
  }

  template <int Dim>
  static const PackMatrix<Dim>& slope(const PackMatrix<Dim>& C, const PackMatrix<Dim>& /*D*/) {
    return C;
  }
};

} // namespace riedel
