/// From the path of a shared library to entries of the catalogue.
#pragma once

#include "core/interface/catalogue.hpp"

#include <filesystem>

namespace riedel {

/// A plug-in that has been loaded.
struct LoadedPlugin {
  std::filesystem::path path;
  std::string compiler;
  std::vector<std::string> brings; ///< "material barodesy", "scheme softened", …
};

/// Loads a library, sees that it was made for this program, and lets it add what it brings. It stays loaded for the
/// rest of the process, so that it outlives its objects. A first try is made in a process of its own, so that a library
/// that crashes while it is loaded, or while it makes an object, does not take the program with it.
/// @throws PluginError, with the path: missing; cannot be loaded (in the loader's words); not a plug-in; made for
/// another version or with a compiler that lays out types otherwise; crashes; brings a name that is taken
LoadedPlugin load_plugin(const std::filesystem::path& path, Catalogue& catalogue);

} // namespace riedel
