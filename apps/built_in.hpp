/// The schemes, laws, searches and averagers that a case can name: those that come with the program, and those of
/// plug-ins.
#pragma once

#include "core/case/plugins.hpp"

namespace riedel {

/// What comes with the program.
Catalogue full_catalogue();

/// The same, and what plug-ins bring: those in the folders of RIEDEL_PLUGIN_PATH, and those named, or named in a case.
/// @throws PluginError
Inventory load_catalogue(const std::vector<std::string>& named = {});
Inventory load_catalogue(const CaseFile& given);

} // namespace riedel
