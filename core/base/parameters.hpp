/// Keys of a case and parameters of a law: one description serves the validator, `--help`, `riedel list` and the docs.
#pragma once

#include <cstdint>
#include <limits>
#include <map>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace riedel {

using Value = std::variant<bool, std::int64_t, double, std::string, std::vector<double>, std::vector<std::int64_t>>;

/// Allowed numbers: from lower to upper, each end included or not. For lists the bounds apply to every entry.
struct Bounds {
  double lower = -std::numeric_limits<double>::infinity();
  double upper = std::numeric_limits<double>::infinity();
  bool lower_included = true, upper_included = true;

  [[nodiscard]] bool contain(double x) const;
  [[nodiscard]] std::string text() const; ///< "(0, 90)", "≥ 0", "> 0"
};
Bounds at_least(double lower);
Bounds more_than(double lower);
Bounds between(double lower, double upper); ///< both ends included
Bounds within(double lower, double upper);  ///< neither end included

/// One key: `section.name`, or a plain parameter name for a law.
struct Key {
  std::string name;
  Value default_value; ///< its type is the key's type
  std::string unit;    ///< "m", "Pa", "deg", "-" (a pure number), "" (not a number)
  Bounds bounds;
  std::string doc;
  std::vector<std::string> choices = {}; ///< allowed texts; empty: any text
  bool any_length = false;               ///< for lists: any number of entries
  /// Values, as written in a case, that this build lacks, and how to get them, as the end of a sentence.
  std::map<std::string, std::string> left_out = {};

  /// A number, or a word of `choices` that may also be replaced by a number because the key has a unit (`step =
  /// "auto"`).
  [[nodiscard]] bool takes_number() const;
};
using Keys = std::vector<Key>;

/// Values in force for a list of keys.
class Values {
public:
  Values() = default;
  explicit Values(const Keys& keys); ///< the defaults

  void set(std::string_view name, Value value) { values_.insert_or_assign(std::string(name), std::move(value)); }
  [[nodiscard]] bool has(std::string_view name) const { return values_.find(name) != values_.end(); }
  [[nodiscard]] const Value& at(std::string_view name) const; ///< throws std::out_of_range that names the key
  [[nodiscard]] double number(std::string_view name) const;   ///< integers count as numbers
  [[nodiscard]] bool is_text(std::string_view name) const { return std::holds_alternative<std::string>(at(name)); }
  [[nodiscard]] std::int64_t integer(std::string_view name) const { return std::get<std::int64_t>(at(name)); }
  [[nodiscard]] bool flag(std::string_view name) const { return std::get<bool>(at(name)); }
  [[nodiscard]] const std::string& text(std::string_view name) const { return std::get<std::string>(at(name)); }
  [[nodiscard]] const std::vector<double>& numbers(std::string_view name) const;
  [[nodiscard]] const std::vector<std::int64_t>& integers(std::string_view name) const;
  /// The values whose names start with `section` and a dot, without that prefix.
  [[nodiscard]] Values section(std::string_view section) const;
  [[nodiscard]] const std::map<std::string, Value, std::less<>>& all() const { return values_; }

private:
  std::map<std::string, Value, std::less<>> values_;
};

/// Shortest text that reads back to the same bits.
std::string exact_text(double x);

/// For messages: rounded to this many significant digits.
std::string short_text(double x, int digits = 3);
/// With this many digits after the decimal point.
std::string fixed_text(double x, int digits);

/// Throws InputError naming the key, the value, the unit and the allowed range of the first value out of bounds.
void check_bounds(const Keys& keys, const Values& values, std::string_view owner);

} // namespace riedel
