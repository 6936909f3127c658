#include "materials/kit/sand.hpp"

namespace riedel {

namespace {
constexpr double quartz = 2650.0; // kg/m³
}

Keys Sand::keys(const Defaults& defaults) {
  Keys keys{
      {"phi_c", defaults.phi_c, "deg", within(0, 90), "critical angle of friction φ_c"},
      {"h_s", defaults.h_s, "Pa", more_than(0), "granular hardness"},
      {"n", defaults.n, "-", within(0, 1), "exponent of compression"},
      {"e_i0", defaults.e_i0, "-", more_than(0), "maximum void ratio at zero pressure"},
      {"e_d0", defaults.e_d0, "-", more_than(0), "minimum void ratio at zero pressure"},
      {"e_c0", defaults.e_c0, "-", more_than(0), "critical void ratio at zero pressure"},
      {"alpha", defaults.alpha, "-", more_than(0), "exponent of density α"},
      {"beta", defaults.beta, "-", at_least(0), "exponent of stiffness β"},
      {"grain_density", quartz, "kg/m3", more_than(0), "density of the grains ρ_s"},
  };
  const Keys control = IntegrationControl::frictional_keys();
  keys.insert(keys.end(), control.begin(), control.end());
  return keys;
}

Sand::Sand(const Values& given, std::string_view law)
    : sin_phi_c(std::sin(given.number("phi_c") * std::numbers::pi / 180.0)),
      h_s(given.number("h_s")),
      n(given.number("n")),
      e_i0(given.number("e_i0")),
      e_d0(given.number("e_d0")),
      e_c0(given.number("e_c0")),
      alpha(given.number("alpha")),
      beta(given.number("beta")),
      grain_density(given.number("grain_density")),
      max_f_d(std::pow((e_i0 - e_d0) / (e_c0 - e_d0), alpha)),
      per_h_s(1.0 / h_s),
      per_e_i0(1.0 / e_i0),
      per_e_range(1.0 / (e_c0 - e_d0)) {
  check_bounds(keys({}), given, law);
  if (!(e_d0 < e_c0 && e_c0 < e_i0))
    throw InputError(std::string(law) + ": the void ratios must obey e_d0 < e_c0 < e_i0; given " + exact_text(e_d0) +
                     ", " + exact_text(e_c0) + ", " + exact_text(e_i0));
}

} // namespace riedel
