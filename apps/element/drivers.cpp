#include "apps/element/drivers.hpp"

#include <algorithm>

namespace riedel {

const std::vector<ElementDriver>& element_drivers() {
  static const std::vector<ElementDriver> all{
      {"point", "one point under mixed control, without a grid", run_point_driver},
      {"mpm", "a specimen of cells between plates, by the material point method", run_mpm_driver},
  };
  return all;
}

std::vector<std::string> element_driver_names() {
  std::vector<std::string> names;
  for (const ElementDriver& driver : element_drivers()) names.push_back(driver.name);
  return names;
}

const ElementDriver& element_driver(const ElementCase& given) {
  return *std::ranges::find(element_drivers(), given.driver.kind, &ElementDriver::name);
}

} // namespace riedel
