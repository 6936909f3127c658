#include "core/case/case_text.hpp"
#include "core/case/toml_reader.hpp"
#include "core/io/readable.hpp"
#include "core/io/toml_words.hpp"

#include <algorithm>
#include <charconv>
#include <optional>

namespace riedel {

namespace {

constexpr std::size_t longest_shown = 80; ///< in messages [bytes]

/// "grid . cells" as grid.cells; none if a part is not a bare or quoted word.
std::optional<std::string> dotted_name(std::string_view text) {
  std::string name;
  for (std::size_t begin = 0; begin <= text.size();) {
    const std::size_t end = std::min(text.find('.', begin), text.size());
    std::string_view part = trimmed(text.substr(begin, end - begin));
    if (part.size() > 2 && part.front() == part.back() && (part.front() == '"' || part.front() == '\''))
      part = part.substr(1, part.size() - 2);
    if (!is_bare_word(part)) return std::nullopt;
    (name += name.empty() ? "" : ".") += part;
    begin = end + 1;
  }
  return name;
}

/// Whether the text can only be TOML, not a plain text: a list, a table, a quoted text, a number.
bool is_meant_as_toml(std::string_view value) {
  double number = 0.0;
  const auto [end, error] = std::from_chars(value.data(), value.data() + value.size(), number);
  return (!value.empty() && std::string_view("[{\"'").find(value.front()) != std::string_view::npos) ||
         (error != std::errc::invalid_argument && end == value.data() + value.size());
}

void refuse_what_is_no_line(std::string_view text, const std::string& shown) {
  if (valid_utf8(text) < text.size()) throw InputError(shown + ": is not UTF-8");
  if (std::ranges::any_of(text, [](char c) { return static_cast<unsigned char>(c) < ' ' && c != '\t'; }))
    throw InputError(shown + ": contains a line break or another control character; allowed: one key and its value");
}

std::vector<RawEntry> values_of(const std::string& key, std::string_view value, const std::string& shown) {
  try {
    std::vector<RawEntry> all = read_toml("x=" + std::string(value), "");
    if (without_quoted(value).find('#') != std::string::npos)
      throw InputError(shown + ": a value cannot contain a comment; put a text with # in quotes");
    for (RawEntry& given : all) given.name.replace(0, 1, key);
    return all;
  } catch (const TomlError& error) {
    if (is_meant_as_toml(value)) throw InputError(shown + ": the value is not TOML: " + error.why);
  }
  const std::string text(value); // a bare word, or a text whose quotes the shell has removed
  return {{.name = key, .place = "", .text = readable(toml_text(text), longest_shown), .items = {text}}};
}

} // namespace

std::vector<RawEntry> read_assignment(std::string_view assignment, const std::string& source) {
  const std::string shown = source + " " + readable(assignment, longest_shown);
  refuse_what_is_no_line(assignment, shown);
  const std::size_t equals = assignment.find('=');
  if (equals == std::string_view::npos) throw InputError(shown + ": expected KEY=VALUE, such as specimen.width=0.05");
  const std::string_view left = assignment.substr(0, equals);
  const auto key = dotted_name(left);
  if (!key) throw InputError(shown + ": '" + readable(left, longest_shown) + "' is not the name of a key");
  std::vector<RawEntry> all = values_of(*key, trimmed(assignment.substr(equals + 1)), shown);
  for (RawEntry& given : all) given.place = source + " " + readable(given.name, longest_shown);
  return all;
}

} // namespace riedel
