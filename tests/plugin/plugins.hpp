/// Plug-ins and UMATs that were built against the installed program, for tests.
#pragma once

#include "apps/program.hpp"
#include "core/io/plugin_loader.hpp"
#include "support/problems.hpp"

namespace riedel::test {

/// Path of an example, or of one of the libraries made for tests.
inline std::string example(const std::string& name) { return PLUGINS "/examples/" + name + ".so"; }
inline std::string library(const std::string& name) { return PLUGINS "/" + name + ".so"; }

/// The built-in catalogue and the entries of a library.
inline Catalogue catalogue_with(const std::string& path) {
  Catalogue all = full_catalogue();
  load_plugin(path, all);
  return all;
}

inline std::shared_ptr<const Material> law_of(const Catalogue& all, const std::string& name,
                                              const std::map<std::string, Value>& with = {}) {
  const auto& entry = all.materials.find(name);
  Values values(entry.description.parameters);
  for (const auto& [key, value] : with) values.set(key, value);
  return entry.make(values);
}

} // namespace riedel::test
