/// The blend of FLIP and PIC, the fluid implicit particle method and the particle-in-cell method: Brackbill & Ruppel
/// (1986), J. Comput. Phys. 65, 314–343. With the share 1 of FLIP it is the update of Sulsky, Chen & Schreyer (1994).
#pragma once

#include "transfers/kit/blend.hpp"
#include "transfers/kit/pointwise.hpp"

namespace riedel {

template <int Dim>
class Flip final : public PointwiseTransfer<Dim, Blend<Dim>> {
public:
  static constexpr std::string_view name = "flip";
  static Keys parameters();
  explicit Flip(const Values& options);

  [[nodiscard]] const Blend<Dim>& blend() const { return this->rule_; }
  [[nodiscard]] std::string damping_text() const override;
};

} // namespace riedel
