#include "core/case/interpolation_keys.hpp"

#include "core/case/plugins.hpp"

#include <algorithm>

namespace riedel {

Keys interpolation_keys(const Catalogue& catalogue) {
  Keys keys{plugin_key("interpolation", "the scheme")};
  for (const auto& scheme : catalogue.in_2d.schemes.entries())
    for (Key key : scheme.description.parameters) {
      key.name = "interpolation." + key.name;
      if (std::ranges::find(keys, key.name, &Key::name) == keys.end()) keys.push_back(std::move(key));
    }
  return keys;
}

void check_interpolation(const Values& values, const Catalogue& catalogue, std::vector<Finding>& errors) {
  const std::string& scheme = values.text("scheme");
  const auto takes = [](const auto& entry, const std::string& option) {
    return std::ranges::find(entry.description.parameters, option, &Key::name) != entry.description.parameters.end();
  };
  for (const Key& key : interpolation_keys(catalogue)) {
    const std::string option = key.name.substr(key.name.find('.') + 1);
    if (option == "plugin" || values.at(key.name) == key.default_value ||
        takes(catalogue.in_2d.schemes.find(scheme), option))
      continue;
    std::string others;
    for (const auto& entry : catalogue.in_2d.schemes.entries())
      if (takes(entry, option)) others += (others.empty() ? "" : ", ") + entry.description.name;
    errors.push_back({{key.name, "scheme"},
                      "means nothing to the scheme \"" + scheme + "\"; leave it out, or take one of " + others});
  }
}

} // namespace riedel
