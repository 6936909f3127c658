#include "support/patterns.hpp"

#include "temporary_folder.hpp"

#include <regex>

namespace riedel::test {

Matches matches_in(const std::string& text, const std::string& pattern) {
  const std::regex expression(pattern);
  Matches found;
  for (std::sregex_iterator it(text.begin(), text.end(), expression), end; it != end; ++it)
    found.emplace_back(it->begin(), it->end());
  return found;
}

bool matches_whole(const std::string& text, const std::string& pattern) {
  return std::regex_match(text, std::regex(pattern));
}

std::string replaced(const std::string& text, const std::string& pattern, const std::string& by) {
  return std::regex_replace(text, std::regex(pattern), by);
}

nlohmann::json parsed(const std::string& text) { return nlohmann::json::parse(text); }

nlohmann::json json_of(const std::filesystem::path& file) { return parsed(file_content(file)); }

} // namespace riedel::test
