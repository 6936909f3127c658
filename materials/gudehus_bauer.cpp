#include "materials/gudehus_bauer.hpp"

namespace riedel {

Keys GudehusBauer::parameters() {
  // Karlsruhe sand, Krzyżanowski et al. (2020).
  return Sand::keys(
      {.phi_c = 30.0, .h_s = 190e6, .n = 0.5, .e_i0 = 1.3, .e_d0 = 0.51, .e_c0 = 0.82, .alpha = 0.3, .beta = 1.0});
}

GudehusBauer::GudehusBauer(const Values& given) : RateLaw(IntegrationControl(given)), sand_(given, name) {
  const double sin_phi = sand_.sin_phi_c;
  c1_ = std::sqrt(3.0 / 8.0) * (3.0 - sin_phi) / sin_phi;                                         // (A6)
  c2_ = 3.0 / 8.0 * (3.0 + sin_phi) / sin_phi;                                                    // (A6)
  const double h_i = 1.0 / (c1_ * c1_) + 1.0 / 3.0 - sand_.max_f_d / (c1_ * std::numbers::sqrt3); // Bauer (1996)
  if (!(h_i > 0.0))
    throw InputError("gudehus_bauer: phi_c, alpha and the void ratios give h_i = " + exact_text(h_i) +
                     "; isotropic compression needs h_i > 0 (a smaller alpha, or e_c0 nearer to e_i0)");
  f_s0_ = sand_.stiffness(h_i);
}

MaterialLimits GudehusBauer::assess(const MaterialBatch& batch) const {
  return assess_sand<1>(*this, batch, [](const auto& parts) { return basic_stiffness(parts); });
}

} // namespace riedel
