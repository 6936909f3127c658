#include "core/campaign/legend.hpp"

#include "core/base/error.hpp"
#include "core/draw/scale.hpp"
#include "core/io/units.hpp"

#include <algorithm>
#include <array>

namespace riedel {

namespace {

/// The symbol of a key in a legend, and the unit in which it is shown.
struct Symbol {
  const char* key;
  const char* symbol;
  const char* unit;  ///< in the case file
  const char* shown; ///< in the legend
  double factor;     ///< from one to the other
};

constexpr std::array symbols{
    Symbol{"nonlocal.length", "l_c", "m", "mm", 1e3},
    Symbol{"specimen.void_ratio", "e₀", "-", "", 1},
    Symbol{"specimen.width", "b₀", "m", "mm", 1e3},
    Symbol{"specimen.height", "h₀", "m", "mm", 1e3},
    Symbol{"imperfection.void_ratio", "e of the patch", "-", "", 1},
    Symbol{"loading.speed", "v", "m/s", "m/s", 1},
    Symbol{"loading.final_strain", "final u/h₀", "-", "%", 100},
    Symbol{"loading.confining_pressure", "σ_c", "Pa", "kPa", 1e-3},
    Symbol{"loading.normal_stress", "σ_n", "Pa", "kPa", 1e-3},
    Symbol{"time.step", "Δt", "s", "s", 1},
};

std::string last_word(const std::string& key) { return key.substr(key.rfind('.') + 1); }

std::string without_quotes(const std::string& text) {
  const bool quoted = text.size() > 1 && (text.front() == '"' || text.front() == '\'') && text.back() == text.front();
  return quoted ? text.substr(1, text.size() - 2) : text;
}

/// The number that a value represents in that unit; none for words.
std::optional<double> number_of(const std::string& value, const std::string& unit) {
  std::size_t end = 0;
  try {
    const double number = std::stod(value, &end);
    if (end == value.size()) return number;
  } catch (const std::logic_error&) { return std::nullopt; }
  try {
    return read_quantity(value, unit);
  } catch (const InputError&) { return std::nullopt; }
}

std::string with_unit(const std::string& number, const std::string& unit) {
  return unit.empty() || unit == "-" ? number : number + " " + unit;
}

std::string unit_of(const std::string& key, const Keys& keys) {
  const auto known = std::ranges::find(keys, key, &Key::name);
  return known == keys.end() ? "" : known->unit;
}

/// "[24,84]" as "24×84".
std::string crossed(const std::string& list) {
  std::string text;
  for (const char c : list)
    if (c == ',')
      text += "×";
    else if (c != '[' && c != ']' && c != ' ')
      text += c;
  return text;
}

std::string text_of(const std::string& key, const std::string& value, const std::string& called, const Keys& keys) {
  if (key == "scheme") return value;
  if (key == "grid.cells") return crossed(value) + " cells";
  const auto symbol = std::ranges::find(symbols, key, &Symbol::key);
  if (symbol == symbols.end()) {
    const std::string unit = unit_of(key, keys);
    const auto number = number_of(value, unit);
    return called + " = " + (number ? with_unit(plain_number(*number), unit) : value);
  }
  const auto number = number_of(value, symbol->unit);
  if (key == "nonlocal.length" && number == 0.0) return "local";
  return std::string(symbol->symbol) + " = " +
         (number ? with_unit(plain_number(*number * symbol->factor), symbol->shown) : value);
}

std::string value_of(const std::vector<Setting>& run, const std::string& key) {
  const auto found = std::ranges::find(run, key, &Setting::first);
  return found == run.end() ? "" : without_quotes(found->second);
}

bool varies(std::span<const std::vector<Setting>> runs, const std::string& key) {
  return std::ranges::any_of(runs, [&](const auto& run) { return value_of(run, key) != value_of(runs.front(), key); });
}

/// The key whose values determine the colour; empty if nothing varies.
std::string key_of_colors(std::span<const std::vector<Setting>> runs) {
  if (varies(runs, "scheme")) return "scheme";
  for (const Setting& setting : runs.front())
    if (varies(runs, setting.first)) return setting.first;
  return "";
}

/// Index of a value among those seen; new ones are appended.
template <class Thing>
std::size_t place_of(std::vector<Thing>& seen, const Thing& thing) {
  const auto found = std::ranges::find(seen, thing);
  if (found != seen.end()) return static_cast<std::size_t>(found - seen.begin());
  seen.push_back(thing);
  return seen.size() - 1;
}

} // namespace

std::string legend_label(const std::vector<Setting>& settings, const Keys& keys) {
  std::string label;
  for (const auto& [key, value] : settings) {
    const auto alike = [name = last_word(key)](const Setting& other) { return last_word(other.first) == name; };
    const std::string called = std::ranges::count_if(settings, alike) > 1 ? key : last_word(key);
    label += (label.empty() ? "" : ", ") + text_of(key, without_quotes(value), called, keys);
  }
  return label;
}

std::size_t color_of_scheme(std::vector<std::string>& schemes, const std::string& scheme) {
  return place_of(schemes, scheme); // those of plug-ins follow, in the order in which they are drawn
}

std::vector<Pen> pens_of(std::span<const std::vector<Setting>> runs, std::vector<std::string> schemes) {
  std::vector<Pen> pens;
  if (runs.empty()) return pens;
  const std::string key = key_of_colors(runs);
  std::vector<std::string> values;
  std::vector<std::vector<Setting>> others;
  for (const auto& run : runs) {
    const std::string value = value_of(run, key);
    std::vector<Setting> rest = run;
    std::erase_if(rest, [&](const Setting& setting) { return setting.first == key; });
    pens.push_back(pen_of_two(key == "scheme" ? color_of_scheme(schemes, value) : place_of(values, value),
                              place_of(others, rest)));
  }
  return pens;
}

} // namespace riedel
