/// JSON, whatever its texts hold.
#pragma once

#include <nlohmann/json.hpp>

namespace riedel {

/// The JSON with a line break at its end. U+FFFD stands for what is no UTF-8, such as in the name of a folder.
/// @param indent blanks in front of each level
std::string json_text(const nlohmann::ordered_json& json, int indent = 2);

} // namespace riedel
