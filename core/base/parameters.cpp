#include "core/base/parameters.hpp"

#include "core/base/error.hpp"

#include <array>
#include <charconv>
#include <cmath>

namespace riedel {

namespace {
std::string bound_text(double x) {
  std::string text = exact_text(x);
  if (text.ends_with(".0")) text.resize(text.size() - 2);
  return text;
}
} // namespace

bool Bounds::contain(double x) const {
  if (!std::isfinite(x)) return false;
  return (lower_included ? x >= lower : x > lower) && (upper_included ? x <= upper : x < upper);
}

std::string Bounds::text() const {
  const bool below = std::isfinite(lower), above = std::isfinite(upper);
  if (below && above)
    return (lower_included ? "[" : "(") + bound_text(lower) + ", " + bound_text(upper) + (upper_included ? "]" : ")");
  if (below) return (lower_included ? "≥ " : "> ") + bound_text(lower);
  if (above) return (upper_included ? "≤ " : "< ") + bound_text(upper);
  return "any number";
}

Bounds at_least(double lower) { return {.lower = lower}; }
Bounds more_than(double lower) { return {.lower = lower, .lower_included = false}; }
Bounds between(double lower, double upper) { return {.lower = lower, .upper = upper}; }
Bounds within(double lower, double upper) {
  return {.lower = lower, .upper = upper, .lower_included = false, .upper_included = false};
}

bool Key::takes_number() const {
  return std::holds_alternative<double>(default_value) ||
         (std::holds_alternative<std::string>(default_value) && !unit.empty());
}

Values::Values(const Keys& keys) {
  for (const Key& key : keys) set(key.name, key.default_value);
}

const Value& Values::at(std::string_view name) const {
  const auto found = values_.find(name);
  if (found == values_.end()) throw std::out_of_range("no value for key '" + std::string(name) + "'");
  return found->second;
}

double Values::number(std::string_view name) const {
  const Value& value = at(name);
  if (const auto* integer = std::get_if<std::int64_t>(&value)) return static_cast<double>(*integer);
  return std::get<double>(value);
}

const std::vector<double>& Values::numbers(std::string_view name) const {
  return std::get<std::vector<double>>(at(name));
}

const std::vector<std::int64_t>& Values::integers(std::string_view name) const {
  return std::get<std::vector<std::int64_t>>(at(name));
}

Values Values::section(std::string_view section) const {
  Values part;
  const std::string prefix = std::string(section) + ".";
  for (auto it = values_.lower_bound(prefix); it != values_.end() && it->first.starts_with(prefix); ++it)
    part.set(std::string_view(it->first).substr(prefix.size()), it->second);
  return part;
}

std::string short_text(double x, int digits) {
  std::array<char, 32> buffer{};
  const auto end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), x, std::chars_format::general, digits);
  return {buffer.data(), end.ptr};
}

std::string fixed_text(double x, int digits) {
  std::array<char, 400> buffer{}; // at most 309 digits before the decimal point
  const auto end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), x, std::chars_format::fixed, digits);
  return {buffer.data(), end.ptr};
}

std::string exact_text(double x) {
  std::array<char, 32> buffer{};
  const double size = std::abs(x);
  const bool plain = size == 0.0 || (size >= 1e-4 && size < 1e7); // 100000, not 1e+05
  const auto end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), x,
                                 plain ? std::chars_format::fixed : std::chars_format::scientific);
  std::string text(buffer.data(), end.ptr);
  if (std::isfinite(x) && text.find_first_of(".e") == std::string::npos) text += ".0"; // a TOML float, not an integer
  return text;
}

void check_bounds(const Keys& keys, const Values& values, std::string_view owner) {
  for (const Key& key : keys) {
    if (!key.takes_number() || values.is_text(key.name)) continue;
    const double x = values.number(key.name);
    if (!key.bounds.contain(x))
      throw InputError(std::string(owner) + ": " + key.name + " = " + bound_text(x) + " is out of range; allowed: " +
                       key.bounds.text() + (key.unit.empty() || key.unit == "-" ? "" : " " + key.unit));
  }
}

} // namespace riedel
