#include "materials/von_wolffersdorff.hpp"

namespace riedel {

Keys VonWolffersdorff::parameters() {
  // Hochstetten sand, von Wolffersdorff (1996).
  return Sand::keys(
      {.phi_c = 33.0, .h_s = 1e9, .n = 0.25, .e_i0 = 1.05, .e_d0 = 0.55, .e_c0 = 0.95, .alpha = 0.25, .beta = 1.5});
}

VonWolffersdorff::VonWolffersdorff(const Values& given) : RateLaw(IntegrationControl(given)), sand_(given, name) {
  const double sin_phi = sand_.sin_phi_c, root_3 = std::numbers::sqrt3;
  a_ = root_3 * (3.0 - sin_phi) / (2.0 * std::numbers::sqrt2 * sin_phi); // (4)
  const double of_strength = (3.0 + a_ * a_) / (root_3 * a_);
  if (!(sand_.max_f_d < of_strength)) // the bracket in (8) must be positive
    throw InputError("von_wolffersdorff: alpha = " + exact_text(sand_.alpha) +
                     " is out of range: isotropic compression would soften; with this phi_c and these void ratios "
                     "allowed: (0, " +
                     short_text(sand_.alpha * std::log(of_strength) / std::log(sand_.max_f_d), 6) + ")");
  f_s0_ = sand_.stiffness(3.0 + a_ * a_ - root_3 * a_ * sand_.max_f_d); // (8)
}

MaterialLimits VonWolffersdorff::assess(const MaterialBatch& batch) const {
  return assess_sand<1>(*this, batch, [](const auto& parts) { return basic_stiffness(parts); });
}

} // namespace riedel
