/// Writes JSON with arbitrary texts.
#pragma once

#include <nlohmann/json.hpp>

namespace riedel {

/// The JSON with a final line break. Invalid UTF-8, for instance in a folder's name, is replaced by U+FFFD.
/// @param indent blanks before each level
std::string json_text(const nlohmann::ordered_json& json, int indent = 2);

} // namespace riedel
