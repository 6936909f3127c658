/// Regular expressions and JSON, compiled once for all tests: each takes longer to compile than most tests.
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace riedel::test {

/// Each place of `text` that matches: the whole first, its groups after.
using Matches = std::vector<std::vector<std::string>>;
Matches matches_in(const std::string& text, const std::string& pattern);

bool matches_whole(const std::string& text, const std::string& pattern);

std::string replaced(const std::string& text, const std::string& pattern, const std::string& by);

/// @throws nlohmann::json::exception for invalid JSON
nlohmann::json parsed(const std::string& text);

nlohmann::json json_of(const std::filesystem::path& file);

} // namespace riedel::test
