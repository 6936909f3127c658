#include "materials/von_wolffersdorff.hpp"

namespace riedel {

Keys VonWolffersdorff::parameters() {
  // Defaults: Hochstetten sand, von Wolffersdorff (1996).
  Keys keys{
      {"phi_c", 33.0, "deg", within(0, 90), "critical angle of friction φ_c"},
      {"h_s", 1e9, "Pa", more_than(0), "granular hardness"},
      {"n", 0.25, "-", within(0, 1), "exponent of compression"},
      {"e_i0", 1.05, "-", more_than(0), "greatest void ratio at zero pressure"},
      {"e_d0", 0.55, "-", more_than(0), "least void ratio at zero pressure"},
      {"e_c0", 0.95, "-", more_than(0), "critical void ratio at zero pressure"},
      {"alpha", 0.25, "-", more_than(0), "exponent of density α"},
      {"beta", 1.5, "-", at_least(0), "exponent of stiffness β"},
      {"grain_density", 2650.0, "kg/m3", more_than(0), "density of the grains ρ_s"},
  };
  const Keys control = IntegrationControl::frictional_keys();
  keys.insert(keys.end(), control.begin(), control.end());
  return keys;
}

VonWolffersdorff::VonWolffersdorff(const Values& given)
    : RateLaw(IntegrationControl(given)),
      h_s_(given.number("h_s")),
      n_(given.number("n")),
      e_i0_(given.number("e_i0")),
      e_d0_(given.number("e_d0")),
      e_c0_(given.number("e_c0")),
      alpha_(given.number("alpha")),
      beta_(given.number("beta")),
      grain_density_(given.number("grain_density")) {
  check_bounds(parameters(), given, name);
  if (!(e_d0_ < e_c0_ && e_c0_ < e_i0_))
    throw InputError("von_wolffersdorff: the void ratios must obey e_d0 < e_c0 < e_i0; given " + exact_text(e_d0_) +
                     ", " + exact_text(e_c0_) + ", " + exact_text(e_i0_));
  const double sin_phi = std::sin(given.number("phi_c") * std::numbers::pi / 180.0), root_3 = std::numbers::sqrt3;
  a_ = root_3 * (3.0 - sin_phi) / (2.0 * std::numbers::sqrt2 * sin_phi); // (4)
  const double of_density = (e_i0_ - e_d0_) / (e_c0_ - e_d0_), of_strength = (3.0 + a_ * a_) / (root_3 * a_);
  if (!(std::pow(of_density, alpha_) < of_strength)) // the bracket in (8) must be positive
    throw InputError("von_wolffersdorff: alpha = " + exact_text(alpha_) +
                     " is out of range: isotropic compression would soften; with this phi_c and these void ratios "
                     "allowed: (0, " +
                     short_text(std::log(of_strength) / std::log(of_density), 6) + ")");
  f0_ = h_s_ / n_ / (3.0 + a_ * a_ - root_3 * a_ * std::pow(of_density, alpha_)); // (8)
  per_h_s_ = 1.0 / h_s_;
  per_e_i0_ = 1.0 / e_i0_;
  per_e_range_ = 1.0 / (e_c0_ - e_d0_);
}

double VonWolffersdorff::density(std::span<const double> state) const { return grain_density_ / (1.0 + state[0]); }

Survey VonWolffersdorff::survey(const MaterialBatch& batch) const {
  return survey_sand<1>(*this, bounds(), batch, [](const auto& parts) { return basic_stiffness(parts); });
}

} // namespace riedel
