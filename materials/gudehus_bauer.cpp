#include "materials/gudehus_bauer.hpp"

namespace riedel {

Keys GudehusBauer::parameters() {
  // Defaults: Karlsruhe sand, Krzyżanowski et al. (2020).
  Keys keys{
      {"phi_c", 30.0, "deg", within(0, 90), "critical angle of friction φ_c"},
      {"h_s", 190e6, "Pa", more_than(0), "granular hardness"},
      {"n", 0.5, "-", within(0, 1), "exponent of compression"},
      {"e_i0", 1.3, "-", more_than(0), "greatest void ratio at zero pressure"},
      {"e_d0", 0.51, "-", more_than(0), "least void ratio at zero pressure"},
      {"e_c0", 0.82, "-", more_than(0), "critical void ratio at zero pressure"},
      {"alpha", 0.3, "-", more_than(0), "exponent of density α"},
      {"beta", 1.0, "-", at_least(0), "exponent of stiffness β"},
      {"grain_density", 2650.0, "kg/m3", more_than(0), "density of the grains ρ_s"},
  };
  const Keys control = IntegrationControl::frictional_keys();
  keys.insert(keys.end(), control.begin(), control.end());
  return keys;
}

GudehusBauer::GudehusBauer(const Values& given)
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
    throw InputError("gudehus_bauer: the void ratios must obey e_d0 < e_c0 < e_i0; given " + exact_text(e_d0_) + ", " +
                     exact_text(e_c0_) + ", " + exact_text(e_i0_));
  const double sin_phi = std::sin(given.number("phi_c") * std::numbers::pi / 180.0);
  c1_ = std::sqrt(3.0 / 8.0) * (3.0 - sin_phi) / sin_phi; // (A6)
  c2_ = 3.0 / 8.0 * (3.0 + sin_phi) / sin_phi;            // (A6)
  h_i_ = 1.0 / (c1_ * c1_) + 1.0 / 3.0 -
         std::pow((e_i0_ - e_d0_) / (e_c0_ - e_d0_), alpha_) / (c1_ * std::numbers::sqrt3); // Bauer (1996)
  if (!(h_i_ > 0.0))
    throw InputError("gudehus_bauer: phi_c, alpha and the void ratios give h_i = " + exact_text(h_i_) +
                     "; isotropic compression needs h_i > 0 (a smaller alpha, or e_c0 nearer to e_i0)");
  per_h_s_ = 1.0 / h_s_;
  per_e_i0_ = 1.0 / e_i0_;
  per_e_range_ = 1.0 / (e_c0_ - e_d0_);
  f_s0_ = h_s_ / (n_ * h_i_);
}

double GudehusBauer::density(std::span<const double> state) const { return grain_density_ / (1.0 + state[0]); }

Survey GudehusBauer::survey(const MaterialBatch& batch) const {
  return survey_sand<1>(*this, bounds(), batch, [](const auto& parts) { return basic_stiffness(parts); });
}

} // namespace riedel
