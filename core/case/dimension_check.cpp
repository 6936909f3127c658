#include "core/case/dimension_check.hpp"

namespace riedel {

void check_offered(const Values& values, const Catalogue& catalogue, int dimensions, std::vector<Finding>& errors) {
  if (dimensions == 2) return;
  const auto check = [&](const std::string& key, const auto& in_space) {
    if (!values.has(key) || in_space.known(values.text(key))) return;
    std::string others;
    for (const std::string& name : in_space.names()) others += name + ", ";
    errors.push_back({{key, "grid.dimensions"},
                      "\"" + values.text(key) + "\" is not offered in three dimensions; take " +
                          (others.empty() ? "" : "one of " + others + "or ") + "grid.dimensions = 2"});
  };
  check("scheme", catalogue.in_3d.schemes);
  check("nonlocal.search", catalogue.in_3d.searches);
  check("nonlocal.averager", catalogue.in_3d.averagers);
  check("time.transfer", catalogue.in_3d.transfers);
}

} // namespace riedel
