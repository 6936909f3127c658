#include "core/case/raw_entry.hpp"

#include "core/base/error.hpp"
#include "core/base/suggestion.hpp"
#include "core/case/case_text.hpp"
#include "core/io/units.hpp"

#include <algorithm>
#include <cmath>

namespace riedel {

namespace {

std::string joined(const std::vector<std::string>& words) {
  std::string text;
  for (const std::string& word : words) text += (text.empty() ? "" : ", ") + word;
  return text;
}

bool bounded(const Bounds& bounds) { return std::isfinite(bounds.lower) || std::isfinite(bounds.upper); }

std::string range_text(const Bounds& bounds) {
  if (!bounded(bounds)) return "";
  const std::string text = bounds.text();
  return (text.front() == '[' || text.front() == '(' ? " in " : " ") + text;
}

std::string number_wanted(const Key& key, std::string_view noun) {
  std::string text = std::string(noun) + range_text(key.bounds);
  if (key.unit.empty()) return text;
  if (key.unit != "-") text += (text.ends_with(']') || text.ends_with(')') ? " " : " in ") + key.unit;
  return text + ", or a text with a unit (" + unit_examples(key.unit) + ")";
}

double number_from(const Scalar& item, const Key& key) {
  double x = 0.0;
  if (const auto* real = std::get_if<double>(&item))
    x = *real;
  else if (const auto* integer = std::get_if<std::int64_t>(&item))
    x = static_cast<double>(*integer);
  else if (const auto* text = std::get_if<std::string>(&item))
    x = read_quantity(*text, key.unit);
  else
    throw InputError("is not a number");
  if (!std::isfinite(x)) throw InputError("is not a finite number");
  if (!key.bounds.contain(x)) throw InputError("is out of range");
  return x;
}

/// Why another value is not accepted as an integer.
std::string no_integer_text(const Scalar& item) {
  constexpr double exact = 9007199254740992.0; // up to 2^53 a double holds every integer
  const auto* real = std::get_if<double>(&item);
  if (real == nullptr || std::trunc(*real) != *real || std::abs(*real) > exact) return "is not an integer";
  return "is not an integer, which has no point and no exponent: write " +
         std::to_string(static_cast<std::int64_t>(*real));
}

std::int64_t integer_from(const Scalar& item, const Key& key) {
  const auto* integer = std::get_if<std::int64_t>(&item);
  if (integer == nullptr) throw InputError(no_integer_text(item));
  if (!key.bounds.contain(static_cast<double>(*integer))) throw InputError("is out of range");
  return *integer;
}

void refuse_left_out(const std::string& value, const Key& key) {
  if (const auto missing = key.left_out.find(value); missing != key.left_out.end()) throw InputError(missing->second);
}

/// A text: one of the choices, any text, or a quantity when the key takes numbers too.
Value text_from(const Scalar& item, const Key& key) {
  const auto* text = std::get_if<std::string>(&item);
  if (text != nullptr) refuse_left_out(*text, key);
  const bool listed = text != nullptr && std::ranges::find(key.choices, *text) != key.choices.end();
  if (listed || (text != nullptr && key.choices.empty() && !key.takes_number())) return *text;
  if (key.takes_number()) return number_from(item, key);
  if (text == nullptr) throw InputError("is not a text");
  throw InputError("is not known" + did_you_mean(*text, key.choices));
}

template <class Number, class Read>
Value list_from(const RawEntry& given, const Key& key, Read read) {
  if (given.kind != RawEntry::Kind::list) throw InputError("is not a list");
  const std::size_t length = std::get<std::vector<Number>>(key.default_value).size();
  if (!key.any_length && given.items.size() != length)
    throw InputError("has " + std::to_string(given.items.size()) + " entries instead of " + std::to_string(length));
  std::vector<Number> numbers;
  try {
    for (const Scalar& item : given.items) numbers.push_back(read(item, key));
  } catch (const InputError& problem) {
    throw InputError("at place " + std::to_string(numbers.size() + 1) + " " + problem.what());
  }
  return numbers;
}

Value convert_plainly(const RawEntry& given, const Key& key) {
  if (given.kind == RawEntry::Kind::empty_section) throw InputError("is a section, not a value");
  if (std::holds_alternative<std::vector<double>>(key.default_value)) return list_from<double>(given, key, number_from);
  if (std::holds_alternative<std::vector<std::int64_t>>(key.default_value))
    return list_from<std::int64_t>(given, key, integer_from);
  if (given.kind == RawEntry::Kind::list) throw InputError("is a list");
  const Scalar& item = given.items.front();
  if (std::holds_alternative<std::string>(key.default_value) || !key.choices.empty()) return text_from(item, key);
  if (std::holds_alternative<double>(key.default_value)) return number_from(item, key);
  if (std::holds_alternative<std::int64_t>(key.default_value)) return integer_from(item, key);
  if (!std::holds_alternative<bool>(item)) throw InputError("is not true or false");
  refuse_left_out(std::get<bool>(item) ? "true" : "false", key);
  return std::get<bool>(item);
}

} // namespace

std::string wanted(const Key& key) {
  if (const auto* list = std::get_if<std::vector<double>>(&key.default_value))
    return "a list of " + std::to_string(list->size()) + ", each " + number_wanted(key, "a number") + ", such as " +
           toml_text(key.default_value);
  if (const auto* list = std::get_if<std::vector<std::int64_t>>(&key.default_value))
    return "a list of " + std::to_string(list->size()) + ", each an integer" + range_text(key.bounds) + ", such as " +
           toml_text(key.default_value);
  if (std::holds_alternative<std::int64_t>(key.default_value)) return "an integer" + range_text(key.bounds);
  if (std::holds_alternative<bool>(key.default_value)) return key.left_out.contains("true") ? "false" : "true or false";
  if (!key.takes_number()) return key.choices.empty() ? "any text" : joined(key.choices);
  return (key.choices.empty() ? "" : joined(key.choices) + ", or ") + number_wanted(key, "a number");
}

Value convert(const RawEntry& given, const Key& key) {
  try {
    return convert_plainly(given, key);
  } catch (const InputError& problem) {
    throw InputError(given.text + " " + problem.what() + "; allowed: " + wanted(key));
  }
}

} // namespace riedel
