/// The Taylor particle-in-cell transfer, TPIC: Nakamura, Matsumura & Mizutani (2023), Comput. Methods Appl. Mech.
/// Engrg. 403, 115720.
#pragma once

#include "core/step/kernels/gather.hpp"
#include "transfers/kit/affine.hpp"
#include "transfers/kit/blend.hpp"

namespace riedel {

/// A point stores the gradient C_p = Σ_i v_i ⊗ ∇N_ip [1/s] of the velocities from which it took its own, and gives its
/// nodes the Taylor series about it.
template <int Dim>
struct TaylorGradient {
  static constexpr bool keeps_gradient = true;

  /// Σ_i N_ip v_i and C_p of eight points. @return C_p by columns
  static PackMatrix<Dim> gather(const StencilEntries<Dim>& stencil, const StencilEntries<Dim>& /*moments*/,
                                const Nodes<Dim>& nodes, Gathered<Dim>& sum) {
    riedel::gather<Use::both>(stencil, nodes.motion, sum);
    return sum.gradient.vectors();
  }

  static const PackMatrix<Dim>& gradient(const PackMatrix<Dim>& C, const PackMatrix<Dim>& /*D*/) { return C; }
};

template <int Dim>
class Tpic final : public AffineTransfer<Dim, TaylorGradient<Dim>, TakeFromGrid<Dim>> {
public:
  static constexpr std::string_view name = "tpic";

  [[nodiscard]] TransferTraits traits() const override { return {.spread = TransferTraits::Spread::wanted}; }
};

} // namespace riedel
