/// A transfer: ASFLIP, affine as APIC and with FLIP's changes of velocity, whose points follow their own velocities
/// where the material separates. Fei, Guo, Wu, Huang & Gao (2021), ACM Trans. Graph. 40(4), 109.
#include "core/step/transfer_plugin.hpp"
#include "transfers/kit/affine.ipp"
#include "transfers/kit/apic_gradient.hpp"
#include "transfers/kit/blend.hpp"

namespace {

using namespace riedel;

/// v_p ← Σ N_ip v_i + α δ_p and x_p += Δt (Σ N_ip v_i + β α δ_p), where δ_p = v_p + Δt Σ N_ip a_i − Σ N_ip v_i is the
/// part of v_p that the grid does not resolve; β applies to points that have expanded since the start, and is 0 for
/// others.
template <int Dim>
struct Apart {
  double alpha = 0.97, beta = 1.0; ///< [-]

  [[nodiscard]] auto over(double dt) const {
    return [*this, dt](const Gathered<Dim>& sum, const Points<Dim>& points, Index p) {
      NewMotion<Dim> motion = new_motion(sum, points, p, alpha, dt);
      const Pack grown = Pack::load(points.volume[0] + p) - Pack::load(points.initial_volume[0] + p);
      const Pack share = select(grown > Pack(0.0), Pack(beta), Pack(0.0));
      for (int a = 0; a < Dim; ++a) // Σ N v + α δ is the new velocity
        motion.displacement_increment[a] += share * (Pack(dt) * motion.velocity[a] - motion.displacement_increment[a]);
      return motion;
    };
  }
};

template <int Dim>
class Asflip final : public AffineTransfer<Dim, ApicGradient<Dim>, Apart<Dim>> {
public:
  static constexpr std::string_view name = "asflip", summary = "affine, with FLIP's changes and points that separate",
                                    source = "Fei, Guo, Wu, Huang & Gao (2021)";
  static Keys parameters() {
    return {{"asflip", 0.97, "-", between(0, 1), "share of FLIP in a step, the rest is APIC"},
            {"asflip_apart", 1.0, "-", between(0, 1), "how far points that have expanded follow their own velocities"}};
  }
  explicit Asflip(const Values& given)
      : AffineTransfer<Dim, ApicGradient<Dim>, Apart<Dim>>({given.number("asflip"), given.number("asflip_apart")}) {}

  [[nodiscard]] TransferTraits traits() const override { return {.spread = TransferTraits::Spread::needed}; }
  [[nodiscard]] std::string damping_text() const override {
    return "ASFLIP " + short_text(this->rule_.alpha) + " by step";
  }
};

} // namespace

RIEDEL_PLUGIN(riedel::transfer<Asflip>)
