/// JSON files that may have been damaged, or written by somebody else.
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>

namespace riedel {

/// @throws InputError that names the file, for what cannot be read, is no JSON, or is nested deeper than anything that
/// Riedel writes
nlohmann::ordered_json read_json(const std::filesystem::path& file);

} // namespace riedel
