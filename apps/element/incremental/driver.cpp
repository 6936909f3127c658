#include "apps/element/incremental/driver.hpp"

#include "apps/element/incremental/case.hpp"
#include "core/base/error.hpp"
#include "core/case/case_text.hpp"
#include "core/io/units.hpp"

#include <algorithm>
#include <array>
#include <map>

namespace riedel {

namespace {

constexpr std::int64_t max_numbers = 10000; ///< parameters, or state variables

/// The order of parameters.inp for the laws of hypoplastic sand, as in the UMAT at soilmodels.com.
const std::vector<std::string> sand{"phi_c", "cohesion_pressure", "h_s", "n", "e_d0", "e_c0", "e_i0", "alpha", "beta"};
const std::vector<std::string> sand_laws{"von_wolffersdorff", "gudehus_bauer"};
const std::vector<std::string> intergranular{"m_R", "m_T", "R", "beta_R", "chi"}; ///< behind those of the law
constexpr double min_m_R = 0.5;                 ///< intergranular strain is active for a larger m_R
constexpr std::size_t void_ratio = 7, pore = 8; ///< numbers in STATEV; before them, the intergranular strain
constexpr std::size_t last_note = 13;           ///< STATEV 9 to 13 are the UMAT's own notes
constexpr double min_void_ratio = 1e-3;         ///< below it, STATEV(7) takes the sixteenth parameter

/// The initial state in parameters.inp.
struct Start {
  std::optional<double> void_ratio;
};

void refuse_law(const InputLines& lines, const std::string& law) {
  std::string known;
  for (const std::string& each : sand_laws) known += (known.empty() ? "" : ", ") + each;
  lines.refuse("no order of parameters is known for the law '" + law + "'; known: " + known +
               " (another law than the file's: --set material.model=LAW; a UMAT: --set material.library=LIB.so)");
}

/// The first line, without a comment after '#'.
std::string name_in(InputLines& lines) {
  std::string name = lines.line("the name of the law");
  name.erase(std::min(name.find('#'), name.size()));
  name.erase(0, name.find_first_not_of(" \t\r"));
  name.erase(name.find_last_not_of(" \t\r") + 1);
  if (name.empty()) lines.refuse("needs the name of the law");
  return name;
}

void read_umat_parameters(IncrementalCase& into, InputLines& lines, const std::string& name) {
  into.set(lines, "material.model", "\"umat\"");
  into.set(lines, "material.name", toml_text(name));
  const std::int64_t count = lines.integer("the number of parameters", 0, max_numbers);
  std::vector<double> all;
  while (static_cast<std::int64_t>(all.size()) < count)
    all.push_back(lines.number("parameter " + std::to_string(all.size() + 1)));
  into.set(lines, "material.parameters", toml_text(all));
}

void read_intergranular(IncrementalCase& into, InputLines& lines, std::int64_t count) {
  const auto all = static_cast<std::int64_t>(sand.size() + intergranular.size());
  const double m_R = lines.number(intergranular.front());
  const bool at_work = m_R > min_m_R;
  if (at_work && count < all)
    lines.refuse("m_R = " + exact_text(m_R) + " asks for intergranular strain, which needs " + std::to_string(all) +
                 " parameters");
  if (at_work) {
    into.set(lines, "material.intergranular_strain", "true");
    into.set(lines, "material.m_R", m_R);
  }
  for (std::size_t i = 1; i < intergranular.size() && static_cast<std::int64_t>(sand.size() + i) < count; ++i) {
    const double x = lines.number(intergranular[i]);
    if (at_work) into.set(lines, "material." + intergranular[i], x);
  }
}

/// The fifteenth parameter is the bulk modulus of water, the sixteenth a void ratio for a state that has none.
void read_water(IncrementalCase& into, InputLines& lines) {
  const double K_w = lines.number("the bulk modulus of water");
  if (K_w < 0.0) lines.refuse("a bulk modulus of water of " + exact_text(K_w) + "; allowed: 0 or more");

  into.set(lines, "specimen.water_bulk_modulus", K_w * into.stress_unit);
}

Start read_sand_parameters(IncrementalCase& into, InputLines& lines, const std::string& law) {
  constexpr std::int64_t water = 15, e_0 = 16;
  if (std::ranges::find(sand_laws, law) == sand_laws.end()) refuse_law(lines, law);
  into.set(lines, "material.model", toml_text(law));
  const std::int64_t count = lines.integer("the number of parameters", 0, max_numbers);
  const auto own = static_cast<std::int64_t>(sand.size());
  if (count < own)
    lines.refuse(std::to_string(count) + " parameters are too few: " + law + " needs " + std::to_string(own));
  if (count > e_0)
    lines.refuse(std::to_string(count) + " parameters are too many: those after the " + std::to_string(e_0) +
                 "th are not known");
  for (const std::string& parameter : sand) {
    const double x = lines.number(parameter);
    const bool of_pressure = parameter == "h_s" || parameter == "cohesion_pressure";
    into.set(lines, "material." + parameter, of_pressure ? into.stress_unit * x : x);
  }
  Start start;
  if (count > own) read_intergranular(into, lines, count);
  if (count >= water) read_water(into, lines);
  if (count >= e_0) start.void_ratio = lines.number("the void ratio");
  return start;
}

void read_stress(IncrementalCase& into, InputLines& lines) {
  const std::int64_t components = lines.integer("the number of stress components", 0, 6);
  std::array<double, 6> stress{};
  for (std::int64_t c = 0; c < components; ++c)
    stress[static_cast<std::size_t>(c)] = into.stress_unit * lines.number("a stress component");
  into.set(lines, "initial.sigma", toml_text(std::vector{0.0 - stress[0], 0.0 - stress[1], 0.0 - stress[2]}));
  into.set(lines, "initial.tau", stress[3]);
  into.set(lines, "initial.tau_13", stress[4]);
  into.set(lines, "initial.tau_23", stress[5]);
}

/// STATEV; values missing at the end of the file are zero.
std::vector<double> read_states(InputLines& lines) {
  std::vector<double> all(static_cast<std::size_t>(lines.integer("the number of state variables", 0, max_numbers)));
  std::string line;
  for (std::size_t s = 0; s < all.size() && lines.next(line); ++s)
    all[s] = lines.numbers_in(line, 1, "statev(" + std::to_string(s + 1) + ")").front();
  return all;
}

void take_sand_states(IncrementalCase& into, const InputLines& lines, std::vector<double> state, const Start& start) {
  if (state.size() < void_ratio && !start.void_ratio)
    lines.refuse("needs 7 state variables or more: the void ratio is statev(7)");
  state.resize(std::max(state.size(), pore), 0.0);
  for (std::size_t s = 3; s < void_ratio - 1; ++s)
    if (state[s] != 0.0) lines.refuse("a shear of the intergranular strain at the start is not supported; only 0");
  for (std::size_t s = last_note; s < state.size(); ++s)
    if (state[s] != 0.0)
      lines.refuse("statev(" + std::to_string(s + 1) + ") = " + exact_text(state[s]) + " is not known; only 0");
  into.set(lines, "initial.intergranular_strain",
           toml_text(std::vector{0.0 - state[0], 0.0 - state[1], 0.0 - state[2]}));
  double e = state[void_ratio - 1];
  if (start.void_ratio && e < min_void_ratio) e = *start.void_ratio;
  into.set(lines, "specimen.void_ratio", e);
  into.set(lines, "initial.pore_pressure", -into.stress_unit * state[pore - 1]);
}

/// The number of the void ratio in STATEV by the names that the settings give it, from 0.
std::optional<std::size_t> named_void_ratio(const CaseFile& settings) {
  std::istringstream words(settings.peek_text("material.state_names").value_or(""));
  std::size_t number = 0;
  for (std::string word; std::getline(words, word, ',');) {
    word.erase(0, word.find_first_not_of(' '));
    word.erase(word.find_last_not_of(' ') + 1);
    if (word == "void_ratio") return number;
    number += word.find(':') == std::string::npos ? 1 : 6;
  }
  return std::nullopt;
}

void take_umat_states(IncrementalCase& into, const InputLines& lines, const std::vector<double>& state,
                      const CaseFile& settings) {
  into.set(lines, "material.state", toml_text(state));
  if (const auto e = named_void_ratio(settings); e && *e < state.size())
    into.set(lines, "specimen.void_ratio", state[*e]);
}

std::filesystem::path usual(const std::string& key) {
  return key == "param" ? "parameters.inp" : key == "ini" ? "initialconditions.inp" : "test.inp";
}

} // namespace

IncrementalFiles incremental_files(const std::vector<std::string>& wishes) {
  std::filesystem::path folder = ".";
  std::map<std::string, std::filesystem::path> names;
  for (const char* key : {"param", "ini", "test"}) names[key] = usual(key);
  for (const std::string& wish : wishes) {
    const std::string key = wish.substr(0, std::min(wish.find('='), wish.size()));
    if (key != wish && names.contains(key)) {
      names[key] = wish.substr(key.size() + 1);
    } else if (std::filesystem::is_regular_file(wish)) {
      folder = std::filesystem::path(wish).parent_path();
      names["test"] = std::filesystem::path(wish).filename();
    } else if (std::filesystem::is_directory(wish)) {
      folder = wish;
    } else {
      throw InputError("--import " + wish +
                       ": there is no such folder or file; allowed: a folder, a file like test.inp, param=FILE, "
                       "ini=FILE, test=FILE");
    }
  }
  return {folder / names["param"], folder / names["ini"], folder / names["test"]};
}

CaseFile import_incremental_driver(const IncrementalFiles& files, const CaseFile& settings) {
  IncrementalCase into;
  const std::optional<std::string> wish = settings.peek_text("material.model");
  const bool umat = wish == "umat" || (!wish && settings.peek_text("material.library"));
  if (umat) {
    const std::string unit = settings.peek_text("material.stress_unit").value_or("kPa");
    into.stress_unit = read_quantity("1 " + unit, "Pa");
    into.given.override_with("material.stress_unit=" + unit, files.parameters.string() + ":");
  }
  InputLines parameters(files.parameters);
  const std::string name = name_in(parameters);
  Start start;
  if (umat)
    read_umat_parameters(into, parameters, name);
  else
    start = read_sand_parameters(into, parameters, wish.value_or(name));
  InputLines initial(files.initial_conditions);
  read_stress(into, initial);
  const std::vector<double> state = read_states(initial);
  if (umat)
    take_umat_states(into, initial, state, settings);
  else
    take_sand_states(into, initial, state, start);
  read_incremental_test(into, files.test);
  return std::move(into.given);
}

} // namespace riedel
