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
}

double GudehusBauer::density(std::span<const double> state) const { return grain_density_ / (1.0 + state[0]); }

Survey GudehusBauer::survey(const MaterialBatch& batch) const {
  Survey answer;
  double fastest = 0.0; // c²
  for (Index p = 0; p < batch.size; ++p) {
    if (batch.state[1][p] > 0.0) continue; // separated: no stiffness
    Sym<double> sigma;
    for (std::size_t c = 0; c < 6; ++c) sigma.m[c] = batch.stress[c][p];
    const double P = -trace(sigma), e = batch.state[0][p];
    if (!(P > 0.0)) continue;
    const Factors<double> f = factors(P, e);
    const Sym<double> s = sigma / trace(sigma), s_dev = deviator(s);
    const double a = a1(s_dev);
    // The greatest σ̂:nn is the greatest principal value; unloading along n adds |N_nn| to the loading stiffness.
    const double lode = std::acos(-cos_3_lode(s_dev)) / 3.0;
    const double s_nn = 1.0 / 3.0 + std::sqrt(2.0 / 3.0) * norm(s_dev) * std::cos(lode);
    const double stiffness = f.f_s * (a * a + s_nn * s_nn + f.f_d * a * (2.0 * s_nn - 1.0 / 3.0));
    fastest = std::max(fastest, stiffness * (1.0 + e) / grain_density_);
    answer.out_of_bounds += e < f.e_d || e > f.e_i;
  }
  answer.wave_speed = std::sqrt(fastest);
  return answer;
}

} // namespace riedel
