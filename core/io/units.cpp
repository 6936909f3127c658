#include "core/io/units.hpp"

#include "core/base/error.hpp"
#include "core/io/readable.hpp"
#include "core/io/toml_words.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <numbers>
#include <optional>
#include <utility>

namespace riedel {

namespace {

/// A unit is factor × 10^tens × m^a kg^b s^c rad^d. The power of ten is separate so that it can be added to the decimal
/// exponent of the text without losing a bit.
struct Unit {
  std::array<int, 4> dimension{}; ///< exponents of m, kg, s, rad
  int tens = 0;
  double factor = 1.0;

  void multiply(const Unit& other, int exponent) {
    for (std::size_t i = 0; i < dimension.size(); ++i) dimension[i] += exponent * other.dimension[i];
    tens += exponent * other.tens;
    factor *= std::pow(other.factor, exponent);
  }
};

struct Base {
  std::string_view symbol;
  Unit unit;
  bool takes_prefix;
};

constexpr std::size_t longest_shown = 40; ///< in messages [bytes]
constexpr double degree = std::numbers::pi / 180.0;
const std::array<Base, 17> bases{{
    {"m", {{1, 0, 0, 0}}, true},
    {"g", {{0, 1, 0, 0}, -3}, true},
    {"t", {{0, 1, 0, 0}, 3}, false},
    {"s", {{0, 0, 1, 0}}, true},
    {"min", {{0, 0, 1, 0}, 0, 60.0}, false},
    {"h", {{0, 0, 1, 0}, 0, 3600.0}, false},
    {"Hz", {{0, 0, -1, 0}}, true},
    {"N", {{1, 1, -2, 0}}, true},
    {"Pa", {{-1, 1, -2, 0}}, true},
    {"bar", {{-1, 1, -2, 0}, 5}, true},
    {"J", {{2, 1, -2, 0}}, true},
    {"W", {{2, 1, -3, 0}}, true},
    {"rad", {{0, 0, 0, 1}}, true},
    {"deg", {{0, 0, 0, 1}, 0, degree}, false},
    {"%", {{}, -2}, false},
    {"1", {}, false},
    {"-", {}, false},
}};
constexpr std::array<std::pair<char, int>, 7> prefixes{
    {{'G', 9}, {'M', 6}, {'k', 3}, {'c', -2}, {'m', -3}, {'u', -6}, {'n', -9}}};

std::optional<Unit> find_base(std::string_view symbol) {
  for (const Base& base : bases)
    if (base.symbol == symbol) return base.unit;
  for (const auto& [letter, tens] : prefixes) {
    if (symbol.empty() || symbol.front() != letter) continue;
    for (const Base& base : bases) {
      if (!base.takes_prefix || base.symbol != symbol.substr(1)) continue;
      Unit unit = base.unit;
      unit.tens += tens;
      return unit;
    }
  }
  return std::nullopt;
}

/// One factor: a symbol followed by an exponent: "m3", "m^3", "s-1".
bool multiply_factor(Unit& unit, std::string_view text, int sign) {
  std::size_t split = text.find_first_of("^-+0123456789", 1);
  const std::string_view symbol = text.substr(0, split);
  int exponent = 1;
  if (split != std::string_view::npos) {
    if (text[split] == '^') ++split;
    const auto [end, error] = std::from_chars(text.data() + split, text.data() + text.size(), exponent);
    if (error != std::errc{} || end != text.data() + text.size() || std::abs(exponent) > 9) return false;
  }
  const std::optional<Unit> base = find_base(symbol);
  if (base) unit.multiply(*base, sign * exponent);
  return base.has_value();
}

std::string in_ascii(std::string_view text) {
  constexpr std::array<std::pair<std::string_view, std::string_view>, 13> signs{
      {{"²", "2"},
       {"³", "3"},
       {"¹", "1"},
       {"⁻", "-"},
       {"−", "-"}, // the sign of minus
       {"µ", "u"},
       {"μ", "u"},
       {"°", "deg"},
       {"·", "*"},
       {"⋅", "*"},
       {"\u00a0", " "}, // spaces that do not break
       {"\u202f", " "},
       {"\u2009", " "}}};
  std::string answer(text);
  for (const auto& [sign, plain] : signs)
    for (std::size_t at = answer.find(sign); at != std::string::npos; at = answer.find(sign, at))
      answer.replace(at, sign.size(), plain);
  return answer;
}

std::optional<Unit> parse_unit(std::string_view text) {
  Unit unit;
  int sign = 1;
  for (std::size_t begin = 0; begin <= text.size();) {
    const std::size_t end = std::min(text.find_first_of("/* ", begin), text.size());
    if (end == begin || !multiply_factor(unit, text.substr(begin, end - begin), sign)) return std::nullopt;
    sign = end < text.size() && text[end] == '/' ? -1 : 1;
    begin = end + 1;
  }
  return unit;
}

[[noreturn]] void refuse_size() { throw InputError("is too large or too small for a number"); }

/// The number `digits` × 10^tens, rounded once.
double scaled(std::string_view digits, int tens) {
  constexpr int maximum = 10000; // far beyond what a double holds
  const std::size_t split = digits.find_first_of("eE");
  int exponent = 0;
  if (split != std::string_view::npos) {
    const std::size_t start = split + (digits[split + 1] == '+' ? 2 : 1);
    const auto [end, error] = std::from_chars(digits.data() + start, digits.data() + digits.size(), exponent);
    if (error != std::errc{} || exponent < -maximum || exponent > maximum) refuse_size(); // abs(INT_MIN) is negative
  }
  const std::string text = std::string(digits.substr(0, split)) + "e" + std::to_string(exponent + tens);
  double value = 0.0;
  if (std::from_chars(text.data(), text.data() + text.size(), value).ec != std::errc{}) refuse_size();
  return value;
}

} // namespace

double read_quantity(std::string_view given, std::string_view unit) {
  const std::string plain = in_ascii(given);
  std::string_view text = trimmed(plain);
  if (text.starts_with('+')) text.remove_prefix(1);
  double number = 0.0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error == std::errc::invalid_argument || !std::isfinite(number)) throw InputError("is not a number with a unit");
  const std::string_view digits = text.substr(0, static_cast<std::size_t>(end - text.data()));
  const std::string_view symbol = trimmed(text.substr(digits.size()));
  if (symbol.empty()) throw InputError("is a text without a unit; write the number without quotes");
  if (symbol.starts_with(',')) throw InputError("has a comma in its number; write a point");
  const std::optional<Unit> from = parse_unit(symbol), to = parse_unit(unit);
  if (!from) throw InputError("has an unknown unit '" + readable(symbol, longest_shown) + "'");
  if (!to || from->dimension != to->dimension) throw InputError("has a unit of another kind");
  const double value = scaled(digits, from->tens - to->tens);
  const double answer = from->factor == to->factor ? value : value * (from->factor / to->factor);
  if (!std::isfinite(answer)) refuse_size();
  return answer;
}

std::string unit_examples(std::string_view unit) {
  constexpr std::array<std::pair<std::string_view, std::string_view>, 7> examples{{{"m", "m, cm, mm, um"},
                                                                                   {"s", "s, ms, us, min"},
                                                                                   {"Pa", "Pa, kPa, MPa, GPa, bar"},
                                                                                   {"m/s", "m/s, mm/s, mm/min"},
                                                                                   {"deg", "deg, rad"},
                                                                                   {"kg/m3", "kg/m3, g/cm3, t/m3"},
                                                                                   {"-", "%"}}};
  for (const auto& [name, text] : examples)
    if (name == unit) return std::string(text);
  return std::string(unit);
}

} // namespace riedel
