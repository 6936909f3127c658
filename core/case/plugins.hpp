/// Plug-ins that a case or a command names, and those in the folders of RIEDEL_PLUGIN_PATH.
#pragma once

#include "core/case/case_file.hpp"
#include "core/io/plugin_loader.hpp"

namespace riedel {

/// What can be named in a case, and the plug-ins that brought some of it.
struct Inventory {
  Catalogue catalogue;
  std::vector<LoadedPlugin> plugins;
};

/// A catalogue with the plug-ins in the folders of RIEDEL_PLUGIN_PATH (every *.so in them), and those named. A name
/// without a folder is looked for in these folders, too. @throws PluginError
Inventory with_plugins(Catalogue built_in, const std::vector<std::string>& named);

/// With the plug-ins that a case names under `plugin` in its sections. @throws PluginError that tells the place
Inventory with_plugins(Catalogue built_in, const CaseFile& given);

/// `plugin`, of a section that names something which a plug-in can bring.
inline Key plugin_key(const std::string& section, const std::string& what) {
  return {section + ".plugin", std::string(), "", {}, "shared library that brings " + what + "; empty: none"};
}

} // namespace riedel
