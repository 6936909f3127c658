#include "materials/linear_elastic.hpp"

namespace riedel {

Keys LinearElastic::parameters() {
  Keys keys{
      {"youngs_modulus", 20e6, "Pa", more_than(0), "Young's modulus E"},
      {"poissons_ratio", 0.3, "-", within(-1, 0.5), "Poisson's ratio ν"},
      {"density", 1700.0, "kg/m3", more_than(0), "bulk density at the start"},
  };
  const Keys control = IntegrationControl::keys();
  keys.insert(keys.end(), control.begin(), control.end());
  return keys;
}

LinearElastic::LinearElastic(const Values& given) : RateLaw(IntegrationControl(given)) {
  check_bounds(parameters(), given, name);
  const double E = given.number("youngs_modulus"), nu = given.number("poissons_ratio");
  lambda_ = E * nu / ((1.0 + nu) * (1.0 - 2.0 * nu));
  mu_ = E / (2.0 * (1.0 + nu));
  density_ = given.number("density");
}

} // namespace riedel
