/// JSON files that may be damaged or written by another program.
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>

namespace riedel {

/// @throws InputError that names the file if it cannot be read, is not JSON, or is nested more deeply than anything
/// that Riedel writes
nlohmann::ordered_json read_json(const std::filesystem::path& file);

} // namespace riedel
