/// The affine particle-in-cell transfer, APIC: Jiang, Schroeder, Selle, Teran & Stomakhin (2015), ACM Trans. Graph.
/// 34(4), 51; Jiang, Schroeder & Teran (2017), J. Comput. Phys. 338, 137–164.
#pragma once

#include "transfers/kit/affine.hpp"
#include "transfers/kit/apic_gradient.hpp"
#include "transfers/kit/blend.hpp"

namespace riedel {

template <int Dim>
class Apic final : public AffineTransfer<Dim, ApicGradient<Dim>, TakeFromGrid<Dim>> {
public:
  static constexpr std::string_view name = "apic";

  [[nodiscard]] TransferTraits traits() const override {
    return {.spread = TransferTraits::Spread::needed, .keeps_angular_momentum = true};
  }
  [[nodiscard]] Mat<Dim> velocity_moment(const Points<Dim>& points, Index p) const override;
};

} // namespace riedel
