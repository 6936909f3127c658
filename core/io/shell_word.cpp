#include "core/io/shell_word.hpp"

#include <algorithm>
#include <array>
#include <cstdio>

namespace riedel {

namespace {

bool is_control(char c) { return static_cast<unsigned char>(c) < 0x20 || c == 0x7f; }

bool is_plain(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') ||
         std::string_view("_-+=./,:@%").find(c) != std::string_view::npos;
}

std::string in_quotes(const std::string& text) {
  std::string word = "'";
  for (const char c : text) word += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return word + "'";
}

/// A format of printf that prints the text.
std::string format_of(const std::string& text) {
  std::string format;
  for (const char c : text) {
    if (is_control(c)) {
      std::array<char, 8> octal{};
      std::snprintf(octal.data(), octal.size(), "\\%03o", static_cast<unsigned>(c));
      format += octal.data();
    } else {
      format += c == '%' || c == '\\' ? std::string(2, c) : std::string(1, c);
    }
  }
  return format;
}

} // namespace

std::string shell_word(const std::string& text) {
  if (std::ranges::any_of(text, is_control) && !text.ends_with('\n')) // which the shell would remove
    return "\"$(printf " + in_quotes(format_of(text)) + ")\"";
  return !text.empty() && std::ranges::all_of(text, is_plain) ? text : in_quotes(text);
}

} // namespace riedel
