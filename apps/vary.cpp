#include "apps/vary.hpp"

#include "core/base/error.hpp"

#include <algorithm>

namespace riedel {

namespace {

/// Parts between commas that stand in no bracket and in no quotes.
std::vector<std::string> parts_of(const std::string& list) {
  std::vector<std::string> parts(1);
  int depth = 0;
  bool quoted = false;
  for (const char c : list) {
    if (c == '"' || c == '\'') quoted = !quoted;
    if (!quoted) depth += c == '[' ? 1 : c == ']' ? -1 : 0;
    if (c == ',' && depth == 0 && !quoted)
      parts.emplace_back();
    else
      parts.back() += c;
  }
  return parts;
}

/// Letters that every file system takes.
std::string file_name(std::string text) {
  std::ranges::replace_if(
      text, [](char c) { return std::string_view("/\\:*?\"'<>| ").find(c) != std::string_view::npos; }, '_');
  return text;
}

Variant with(const Variant& base, const std::string& key, const std::string& value) {
  Variant variant = base;
  variant.given.override_with(key + "=" + value);
  const std::string short_key = key.substr(key.rfind('.') + 1);
  variant.name += (variant.name.empty() ? "" : ",") + file_name(short_key + "=" + value);
  variant.label += (variant.label.empty() ? "" : ", ") + short_key + " = " + value;
  return variant;
}

} // namespace

std::vector<Variant> variants_of(const CaseFile& given, const std::vector<std::string>& wishes) {
  std::vector<Variant> all{{.given = given, .name = "", .label = ""}};
  for (const std::string& wish : wishes) {
    const std::size_t equals = wish.find('=');
    if (equals == std::string::npos || equals == 0 || equals + 1 == wish.size())
      throw InputError("--vary " + wish + ": expected KEY=A,B,C, such as specimen.void_ratio=0.6,0.75,0.9");
    std::vector<Variant> crossed;
    for (const Variant& variant : all)
      for (const std::string& value : parts_of(wish.substr(equals + 1)))
        crossed.push_back(with(variant, wish.substr(0, equals), value));
    all = std::move(crossed);
  }
  return all;
}

} // namespace riedel
