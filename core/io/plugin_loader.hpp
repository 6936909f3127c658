/// Loads a shared library and adds its entries to the catalogue.
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

/// Loads a library, checks that it was made for this program, and lets it add its entries. It stays loaded until the
/// process ends, so that it outlives its objects. It is first tried in a separate process, so that a library that
/// crashes while it is loaded or makes an object does not crash the program.
/// @throws PluginError, with the path: missing; cannot be loaded (in the loader's words); not a plug-in; made for
/// another version or with a compiler that lays out types differently; crashes; adds a name that is taken
LoadedPlugin load_plugin(const std::filesystem::path& path, Catalogue& catalogue);

} // namespace riedel
