#include "core/io/file_name.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstdio>

namespace riedel {

namespace {

constexpr std::size_t longest = 255; ///< of a name [bytes]
constexpr std::size_t kept = 180;    ///< of a text that is too long [bytes]

bool is_control(char c) { return static_cast<unsigned char>(c) < 0x20 || c == 0x7f; }

/// Fowler, Noll and Vo's hash of 64 bits, FNV-1a, in hexadecimal digits.
std::string hash_of(const std::string& text) {
  std::uint64_t hash = 0xcbf29ce484222325;
  for (const char c : text) hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001b3;
  std::array<char, 17> digits{};
  std::snprintf(digits.data(), digits.size(), "%016llx", static_cast<unsigned long long>(hash));
  return digits.data();
}

/// The first `size` bytes, without an incomplete letter of UTF-8 at the end.
std::string cut(const std::string& text, std::size_t size) {
  while (size > 0 && (static_cast<unsigned char>(text[size]) & 0xc0) == 0x80) --size;
  return text.substr(0, size);
}

} // namespace

bool is_file_name(std::string_view text) {
  return !text.empty() && text.size() <= longest && text.front() != '.' && std::ranges::none_of(text, is_control) &&
         text.find_first_of("/\\") == std::string_view::npos;
}

std::string file_name_for(const std::string& text) {
  std::string name = text;
  std::ranges::replace_if(
      name, [](char c) { return is_control(c) || std::string_view("/\\:*?\"'<>| ").find(c) != std::string_view::npos; },
      '_');
  if (name.starts_with('.')) name.front() = '_';
  return name.size() <= longest ? name : cut(name, kept) + "~" + hash_of(text);
}

} // namespace riedel
