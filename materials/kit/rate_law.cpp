#include "materials/kit/rate_law.hpp"

namespace riedel {

Keys IntegrationControl::keys() {
  return {{.name = "tolerance",
           .default_value = 1e-4,
           .unit = "-",
           .bounds = between(1e-14, 0.1),
           .doc = "error of stress and state variables allowed in one step, relative"}};
}

Keys IntegrationControl::frictional_keys() {
  Keys all = keys();
  all.push_back({.name = "minimum_pressure",
                 .default_value = 10.0,
                 .unit = "Pa",
                 .bounds = more_than(0.0),
                 .doc = "mean pressure below which a point separates or is returned"});
  all.push_back({.name = "cohesion_pressure",
                 .default_value = 0.0,
                 .unit = "Pa",
                 .bounds = at_least(0.0),
                 .doc = "added to the mean pressure in the law, and to that compared with minimum_pressure"});
  return all;
}

IntegrationControl::IntegrationControl(const Values& given)
    : tolerance(given.number("tolerance")),
      minimum_pressure(given.has("minimum_pressure") ? given.number("minimum_pressure") : 0.0),
      cohesion_pressure(given.has("cohesion_pressure") ? given.number("cohesion_pressure") : 0.0) {}

} // namespace riedel
