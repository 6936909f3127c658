#include "materials/kit/elastic_solid.hpp"

namespace riedel {

Keys ElasticSolid::keys() {
  return {
      {"youngs_modulus", 20e6, "Pa", more_than(0), "Young's modulus E"},
      {"poissons_ratio", 0.3, "-", within(-1, 0.5), "Poisson's ratio ν"},
      {"density", 1700.0, "kg/m3", more_than(0), "bulk density at the start"},
  };
}

ElasticSolid::ElasticSolid(const Values& given) : density(given.number("density")) {
  const double E = given.number("youngs_modulus"), nu = given.number("poissons_ratio");
  lambda = E * nu / ((1.0 + nu) * (1.0 - 2.0 * nu));
  mu = E / (2.0 * (1.0 + nu));
}

} // namespace riedel
