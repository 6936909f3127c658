/// Plug-ins named by a case or a command, and those in the folders of RIEDEL_PLUGIN_PATH.
#pragma once

#include "core/case/case_file.hpp"
#include "core/io/plugin_loader.hpp"

namespace riedel {

/// Everything that a case can name, and the plug-ins that provide some of it.
struct Inventory {
  Catalogue catalogue;
  std::vector<LoadedPlugin> plugins;
};

/// A catalogue with the plug-ins in the folders of RIEDEL_PLUGIN_PATH (every *.so in them), and those named. A name
/// without a folder is also searched for in these folders. @throws PluginError
Inventory with_plugins(Catalogue built_in, const std::vector<std::string>& named);

/// With the plug-ins that a case names under `plugin` in its sections. @throws PluginError that gives the place
Inventory with_plugins(Catalogue built_in, const CaseFile& given);

/// `plugin`, for a section that names something a plug-in can provide.
inline Key plugin_key(const std::string& section, const std::string& what) {
  return {section + ".plugin", std::string(), "", {}, "shared library that provides " + what + "; empty: none"};
}

} // namespace riedel
