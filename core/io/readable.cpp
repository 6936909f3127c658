#include "core/io/readable.hpp"

#include <cstdint>

namespace riedel {

namespace {

constexpr std::string_view replacement = "\xEF\xBF\xBD"; // U+FFFD

bool is_control(char32_t c) { return (c < 0x20 && c != '\t') || (c >= 0x7f && c < 0xa0); }

/// Number of bytes in a character, from its first byte; 0: no character begins with it.
std::size_t length_after(unsigned char first) {
  if (first < 0x80) return 1;
  if (first >= 0xC2 && first < 0xE0) return 2;
  if (first >= 0xE0 && first < 0xF0) return 3;
  return first >= 0xF0 && first < 0xF5 ? 4 : 0;
}

struct Character {
  std::size_t length; ///< in bytes; 0 if it is not UTF-8
  char32_t code;
};

Character first_character(std::string_view text) {
  const auto first = static_cast<unsigned char>(text.front());
  const std::size_t length = length_after(first);
  if (length == 0 || text.size() < length) return {0, 0};
  if (length == 1) return {1, first};
  auto code = static_cast<char32_t>(first & (0x7Fu >> length));
  for (std::size_t i = 1; i < length; ++i) {
    const auto next = static_cast<unsigned char>(text[i]);
    if ((next & 0xC0u) != 0x80u) return {0, 0};
    code = code << 6u | (next & 0x3Fu);
  }
  const bool overlong = (length == 3 && code < 0x800) || (length == 4 && code < 0x10000);
  const bool surrogate = code >= 0xD800 && code < 0xE000;
  return {overlong || surrogate || code > 0x10FFFF ? 0 : length, code};
}

} // namespace

std::size_t valid_utf8(std::string_view text) {
  std::size_t at = 0;
  while (at < text.size()) {
    const std::size_t length = first_character(text.substr(at)).length;
    if (length == 0) return at;
    at += length;
  }
  return at;
}

std::string readable(std::string_view text, std::size_t longest) {
  std::string answer;
  for (std::size_t at = 0; at < text.size();) {
    const Character c = first_character(text.substr(at));
    const std::size_t length = c.length == 0 ? 1 : c.length;
    if (at + length > longest) return answer + "...";
    answer += c.length == 0 || is_control(c.code) ? replacement : text.substr(at, length);
    at += length;
  }
  return answer;
}

} // namespace riedel
