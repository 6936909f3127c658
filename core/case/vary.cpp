#include "core/case/vary.hpp"

#include "core/base/error.hpp"
#include "core/io/file_name.hpp"
#include "core/io/readable.hpp"
#include "core/io/toml_words.hpp"

#include <algorithm>
#include <map>

namespace riedel {

namespace {

constexpr std::size_t longest_shown = 80; ///< in messages [bytes]
constexpr std::size_t longest_name =
    200; ///< of a folder's name; file systems allow 255, and frames and drafts append to it [bytes]
constexpr std::size_t max_runs = 1000;

[[noreturn]] void refuse(const std::string& wish, const std::string& why) {
  throw InputError("--vary " + readable(wish, longest_shown) + ": " + why);
}

/// Parts between commas that are outside brackets and quotes.
std::vector<std::string> parts_of(const std::string& wish, std::size_t begin) {
  const std::string plain = without_quoted(wish.substr(begin));
  std::vector<std::string> parts(1);
  std::string open; // brackets that are not yet closed
  for (std::size_t i = 0; i < plain.size(); ++i) {
    const char c = plain[i];
    if (c == '[' || c == '{') open += c == '[' ? ']' : '}';
    if (c == ']' || c == '}') {
      if (!open.ends_with(c)) refuse(wish, std::string("a '") + c + "' has no opening bracket");
      open.pop_back();
    }
    if (c == ',' && open.empty())
      parts.emplace_back();
    else
      parts.back() += wish[begin + i];
  }
  if (!open.empty()) refuse(wish, std::string("a '") + open.back() + "' is missing");
  return parts;
}

/// Eight letters derived from a text (FNV-1a).
std::string digest(std::string_view text) {
  std::uint32_t sum = 2166136261U;
  for (const char c : text) sum = (sum ^ static_cast<unsigned char>(c)) * 16777619U;
  std::string letters(8, '0');
  for (char& letter : letters) {
    letter = "0123456789abcdef"[sum % 16];
    sum /= 16;
  }
  return letters;
}

/// Unique names for folders.
void make_names_fit(std::vector<Variant>& variants) {
  std::map<std::string, int> times;
  for (const Variant& variant : variants) ++times[file_name_for(variant.name)];
  for (Variant& variant : variants) {
    const std::string called = variant.name;
    variant.name = file_name_for(called);
    if (times[variant.name] == 1) continue;
    variant.name.resize(valid_utf8(variant.name.substr(0, longest_name)));
    variant.name += "~" + digest(called);
  }
}

std::string last_word(const std::string& key) { return key.substr(key.rfind('.') + 1); }

/// The last word of the key, or the full key if another one ends in the same word.
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
    refuse(wish, "expected KEY=A,B,C, such as specimen.void_ratio=0.6,0.75,0.9");
  Variation variation{.key = std::string(trimmed(std::string_view(wish).substr(0, equals))), .values = {}};
  for (const std::string& part : parts_of(wish, equals + 1)) {
    const std::string value(trimmed(part));
    if (value.empty()) refuse(wish, "a value of the list is empty");
    if (std::ranges::find(variation.values, value) != variation.values.end())
      refuse(wish, readable(value, longest_shown) + " is given twice");
    if (variation.values.size() == max_runs) refuse(wish, "more than " + std::to_string(max_runs) + " values");
    variation.values.push_back(value);
  }
  return variation;
}

std::vector<Variation> variations_of(const std::vector<std::string>& wishes) {
  std::vector<Variation> variations;
  for (const std::string& wish : wishes) {
    Variation variation = variation_of(wish);
    if (std::ranges::find(variations, variation.key, &Variation::key) != variations.end())
      refuse(wish, variation.key + " is varied twice");
    variations.push_back(std::move(variation));
  }
  return variations;
}

std::vector<Variant> variants_of(const CaseFile& given, const std::vector<Variation>& variations) {
  std::size_t runs = 1;
  for (const Variation& variation : variations) runs = std::min(runs, max_runs) * variation.values.size();
  if (runs > max_runs)
    throw InputError("--vary: the lists make more than " + std::to_string(max_runs) +
                     " runs; allowed: " + std::to_string(max_runs) + " in one campaign");
  std::vector<Variant> all{{.given = given, .name = "", .label = ""}};
  for (const Variation& variation : variations) {
    std::vector<Variant> crossed;
    for (const Variant& variant : all)
      for (const std::string& value : variation.values)
        crossed.push_back(with(variant, variation.key, value, short_name(variation.key, variations)));
    all = std::move(crossed);
  }
  if (!variations.empty()) make_names_fit(all);
  return all;
}

void refuse_same_cases(const std::vector<NamedCase>& cases) {
  std::map<std::string_view, std::string_view> names;
  for (const NamedCase& each : cases)
    if (const auto [before, is_new] = names.emplace(each.text, each.name); !is_new)
      throw InputError("--vary: " + std::string(before->second) + " and " + each.name +
                       " are the same case: a value is given twice, in two spellings");
}

} // namespace riedel
