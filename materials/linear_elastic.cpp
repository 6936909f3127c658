#include "materials/linear_elastic.hpp"

namespace riedel {

Keys LinearElastic::parameters() {
  Keys keys = ElasticSolid::keys();
  const Keys control = IntegrationControl::keys();
  keys.insert(keys.end(), control.begin(), control.end());
  return keys;
}

LinearElastic::LinearElastic(const Values& given) : RateLaw(IntegrationControl(given)), solid_(given) {
  check_bounds(parameters(), given, name);
}

} // namespace riedel
