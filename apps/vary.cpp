#include "apps/vary.hpp"

#include "apps/file_name.hpp"
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

std::string trimmed(const std::string& text) {
  const std::size_t first = text.find_first_not_of(' ');
  return first == std::string::npos ? "" : text.substr(first, text.find_last_not_of(' ') - first + 1);
}

std::string last_word(const std::string& key) { return key.substr(key.rfind('.') + 1); }

/// The last word of the key, or all of it where another key ends alike.
std::string short_name(const std::string& key, const std::vector<Variation>& variations) {
  const auto alike = [&](const Variation& other) { return last_word(other.key) == last_word(key); };
  return std::ranges::count_if(variations, alike) > 1 ? key : last_word(key);
}

Variant with(const Variant& base, const std::string& key, const std::string& value, const std::string& called) {
  Variant variant = base;
  variant.given.override_with(key + "=" + value, "--vary");
  variant.name += (variant.name.empty() ? "" : ",") + called + "=" + value;
  variant.label += (variant.label.empty() ? "" : ", ") + (key == "scheme" ? value : called + " = " + value);
  variant.settings.emplace_back(key, value);
  return variant;
}

} // namespace

Variation variation_of(const std::string& wish) {
  const std::size_t equals = wish.find('=');
  if (equals == std::string::npos || equals == 0 || equals + 1 == wish.size())
    throw InputError("--vary " + wish + ": expected KEY=A,B,C, such as specimen.void_ratio=0.6,0.75,0.9");
  Variation variation{.key = trimmed(wish.substr(0, equals)), .values = {}};
  for (const std::string& part : parts_of(wish.substr(equals + 1))) {
    const std::string value = trimmed(part);
    if (value.empty()) throw InputError("--vary " + wish + ": a value of the list is empty");
    if (std::ranges::find(variation.values, value) != variation.values.end())
      throw InputError("--vary " + wish + ": " + value + " stands twice");
    variation.values.push_back(value);
  }
  return variation;
}

std::vector<Variation> variations_of(const std::vector<std::string>& wishes) {
  std::vector<Variation> variations;
  for (const std::string& wish : wishes) {
    Variation variation = variation_of(wish);
    if (std::ranges::find(variations, variation.key, &Variation::key) != variations.end())
      throw InputError("--vary " + wish + ": " + variation.key + " is varied twice");
    variations.push_back(std::move(variation));
  }
  return variations;
}

std::vector<Variant> variants_of(const CaseFile& given, const std::vector<Variation>& variations) {
  std::vector<Variant> all{{.given = given, .name = "", .label = ""}};
  for (const Variation& variation : variations) {
    std::vector<Variant> crossed;
    for (const Variant& variant : all)
      for (const std::string& value : variation.values)
        crossed.push_back(with(variant, variation.key, value, short_name(variation.key, variations)));
    all = std::move(crossed);
  }
  if (!variations.empty())
    for (Variant& variant : all) variant.name = file_name_for(variant.name);
  return all;
}

} // namespace riedel
