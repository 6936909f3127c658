#pragma once

#include "core/step/kernels/point_motion.hpp"
#include "transfers/kit/affine.ipp"
#include "transfers/kit/apic_gradient.hpp"

namespace riedel {

/// v_p ← Σ N_ip v_i + α (v_p + Δt Σ N_ip a_i − Σ N_ip v_i), and x_p moves by Δt Σ N_ip v_i.
template <int Dim>
struct ShareOfFlip {
  double alpha = 0.97; ///< [-]

  [[nodiscard]] auto over(double dt) const {                                                   // once for a pass
    return [alpha = alpha, dt](const Gathered<Dim>& sum, const Points<Dim>& points, Index p) { // eight points from p on
      const NewMotion<Dim> flip = new_motion(sum, points, p, 1.0, dt);
      NewMotion<Dim> motion = new_motion(sum, points, p, 0.0, dt);
      for (int a = 0; a < Dim; ++a) motion.velocity[a] += Pack(alpha) * (flip.velocity[a] - motion.velocity[a]);
      return motion;
    };
  }
};

/// APIC's gradient and FLIP's changes of velocity.
template <int Dim>
class Aflip final : public AffineTransfer<Dim, ApicGradient<Dim>, ShareOfFlip<Dim>> {
public:
  static constexpr std::string_view name = "aflip";
  static Keys parameters() {
    return {{"aflip", 0.97, "-", between(0, 1), "share of FLIP in a step, the rest is APIC"}};
  }
  explicit Aflip(const Values& options)
      : AffineTransfer<Dim, ApicGradient<Dim>, ShareOfFlip<Dim>>({options.number("aflip")}) {}

  [[nodiscard]] TransferTraits traits() const override { return {.spread = TransferTraits::Spread::needed}; }
};

} // namespace riedel
