/// Rules by which points take their velocities from the grid: see pointwise.hpp.
#pragma once

#include "core/step/kernels/point_motion.hpp"

#include <optional>

namespace riedel {

/// v_p ← α (v_p + Δt Σ N_ip a_i) + (1 − α) Σ N_ip v_i, and x_p moves by Δt Σ N_ip v_i.
template <int Dim>
struct Blend {
  double flip = 0.98; ///< α [-]
  /// λ [1/s]; if given, α = e^(−λ Δt), so that damping does not depend on the step size.
  std::optional<double> damping = {};

  [[nodiscard]] auto over(double dt) const {
    const double share = damping ? std::exp(-*damping * dt) : flip;
    return [share, dt](const Gathered<Dim>& sum, const Points<Dim>& points, Index p) {
      return new_motion(sum, points, p, share, dt);
    };
  }
};

/// v_p ← Σ N_ip v_i: PIC, for transfers that store a gradient.
template <int Dim>
struct TakeFromGrid {
  [[nodiscard]] auto over(double dt) const {
    return [dt](const Gathered<Dim>& sum, const Points<Dim>& points, Index p) {
      return new_motion(sum, points, p, 0.0, dt);
    };
  }
};

} // namespace riedel
