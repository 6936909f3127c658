/// The schemes, laws, searches and averagers that a case can name: those of the program and those of plug-ins.
#pragma once

#include "core/case/plugins.hpp"

namespace riedel {

/// Those of the program.
Catalogue full_catalogue();

/// The same, and those of plug-ins: in the folders of RIEDEL_PLUGIN_PATH, given by path, or named in a case.
/// @throws PluginError
Inventory load_catalogue(const std::vector<std::string>& named = {});
Inventory load_catalogue(const CaseFile& given);

} // namespace riedel
