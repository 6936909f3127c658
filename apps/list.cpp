#include "apps/catalogue.hpp"
#include "apps/commands.hpp"
#include "apps/key_tables.hpp"
#include "core/base/error.hpp"
#include "core/io/suggestion.hpp"

#include <algorithm>
#include <iostream>

namespace riedel {

namespace {

template <class Make>
std::string entries(std::string_view title, const Registry<Make>& registry) {
  std::string text = std::string(title) + "\n";
  for (const auto& [description, make] : registry.entries()) {
    text += "  " + description.name + ": " + description.summary + "\n";
    if (has_source(description)) text += "    " + description.source + "\n";
    text += parameters_help(description.parameters);
  }
  return text;
}

std::string loaded(const std::vector<LoadedPlugin>& plugins) {
  std::string text = "plugins\n";
  for (const LoadedPlugin& plugin : plugins) {
    text += "  " + plugin.path.string() + ", compiled by g++ " + plugin.compiler + "\n";
    for (const std::string& entry : plugin.brings) text += "    " + entry + "\n";
  }
  return plugins.empty() ? text + "  none; RIEDEL_PLUGIN_PATH names folders to look into\n" : text;
}

} // namespace

/// `riedel list`: what can be named in a case.
int list(const Arguments& arguments) {
  const auto [catalogue, plugins] = inventory(arguments.list("plugin", {}));
  const std::vector<std::pair<std::string, std::string>> groups{
      {"schemes", entries("schemes", catalogue.in_2d.schemes)},
      {"materials", entries("materials", catalogue.materials)},
      {"searches", entries("searches", catalogue.in_2d.searches)},
      {"averagers", entries("averagers", catalogue.in_2d.averagers)},
      {"plugins", loaded(plugins)}};
  const std::string wish = arguments.words.empty() ? "" : arguments.words.front();
  std::vector<std::string> names;
  for (const auto& [name, text] : groups) names.push_back(name);
  if (!wish.empty() && std::ranges::find(names, wish) == names.end())
    throw InputError("nothing to list is called '" + wish + "'" + did_you_mean(wish, names) +
                     "; known: schemes, materials, searches, averagers, plugins");
  for (const auto& [name, text] : groups)
    if (wish.empty() || wish == name) std::cout << (name == groups.front().first || !wish.empty() ? "" : "\n") << text;
  return 0;
}

} // namespace riedel
