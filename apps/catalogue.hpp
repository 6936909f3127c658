/// The schemes, laws, searches and averagers that a case can name: those that come with the program, and those of
/// plug-ins.
#pragma once

#include "core/io/case_file.hpp"
#include "core/io/plugin_loader.hpp"

namespace riedel {

/// What comes with the program.
Catalogue full_catalogue();

/// The same, and what plug-ins bring.
struct Inventory {
  Catalogue catalogue;
  std::vector<LoadedPlugin> plugins;
};

/// With the plug-ins in the folders of RIEDEL_PLUGIN_PATH (every *.so in them), and those named. A name without a
/// folder is looked for in these folders, too. @throws PluginError
Inventory inventory(const std::vector<std::string>& named = {});

/// With the plug-ins that a case names under `plugin` in its sections, too. @throws PluginError that tells the place
Inventory inventory(const CaseFile& given);

/// `plugin`, of a section that names something which a plug-in can bring.
inline Key plugin_key(const std::string& section, const std::string& what) {
  return {section + ".plugin", std::string(), "", {}, "shared library that brings " + what + "; empty: none"};
}

} // namespace riedel
