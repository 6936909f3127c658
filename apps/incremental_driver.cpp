#include "apps/incremental_driver.hpp"

#include "apps/input_lines.hpp"
#include "apps/path_keys.hpp"
#include "core/io/case_text.hpp"
#include "core/io/suggestion.hpp"

#include <algorithm>
#include <cstdio>
#include <sstream>

namespace riedel {

namespace {

constexpr double kilo = 1e3; ///< Pa in a kPa

/// The order of parameters.inp by law, as in the UMAT of hypoplastic sand at soilmodels.com.
struct Order {
  const char* law;
  std::vector<std::string> names;
};
const std::vector<Order>& orders() {
  static const std::vector<std::string> sand{"phi_c", "cohesion_pressure", "h_s", "n", "e_d0", "e_c0", "e_i0", "alpha",
                                             "beta"};
  static const std::vector<Order> all{{"von_wolffersdorff", sand}, {"gudehus_bauer", sand}};
  return all;
}
constexpr std::array<const char*, 5> intergranular{"m_R", "m_T", "R", "beta_R", "chi"}; ///< behind those of the law
constexpr double least_m_R = 0.5;       ///< m_R above it puts intergranular strain to work
constexpr int void_ratio_state = 7 - 1; ///< statev(7); before it, the intergranular strain
constexpr int most_components = 6, most_states = 1000, most_parameters = 1000, most_repeats = 1'000'000,
              most_legs = 1000;

/// A key of the case, at the place that it was read from.
void set(CaseFile& given, const InputLines& from, const std::string& key, const std::string& value) {
  given.override_with(key + "=" + value, from.place());
}

const Order& order_of(const InputLines& lines, const std::string& law) {
  std::string known;
  for (const Order& order : orders()) {
    if (order.law == law) return order;
    known += (known.empty() ? "" : ", ") + std::string(order.law);
  }
  lines.refuse("no order of parameters is known for the law '" + law + "'; known: " + known +
               " (another law than the file's: --set material.model=LAW)");
}

void read_parameters(CaseFile& given, const std::filesystem::path& path, const std::optional<std::string>& model) {
  InputLines lines(path);
  const std::string name = lines.word("the name of the law");
  const Order& order = order_of(lines, model.value_or(name));
  set(given, lines, "material.model", "\"" + std::string(order.law) + "\"");
  const auto count = static_cast<std::size_t>(lines.count("the number of parameters", most_parameters));
  if (count < order.names.size())
    lines.refuse(std::to_string(count) + " parameters are too few: " + order.law + " needs " +
                 std::to_string(order.names.size()));
  for (const std::string& parameter : order.names) {
    const double x = lines.number(parameter);
    const bool of_pressure = parameter == "h_s" || parameter == "cohesion_pressure";
    set(given, lines, "material." + parameter, exact_text(of_pressure ? kilo * x : x));
  }
  if (count == order.names.size()) return;
  const double m_R = lines.number("m_R");
  if (m_R <= least_m_R) return;
  if (count < order.names.size() + intergranular.size())
    lines.refuse("m_R = " + exact_text(m_R) + " asks for intergranular strain, which needs " +
                 std::to_string(order.names.size() + intergranular.size()) + " parameters");
  set(given, lines, "material.intergranular_strain", "true");
  set(given, lines, "material.m_R", exact_text(m_R));
  for (const char* parameter : intergranular)
    if (parameter != intergranular.front())
      set(given, lines, std::string("material.") + parameter, exact_text(lines.number(parameter)));
}

void read_initial_conditions(CaseFile& given, const std::filesystem::path& path) {
  InputLines lines(path);
  const int components = lines.count("the number of stress components", most_components);
  std::array<double, most_components> stress{};
  for (std::size_t c = 0; c < static_cast<std::size_t>(components); ++c) {
    const double x = lines.number("a stress component");
    if (c > 3 && x != 0.0) lines.refuse("a shear stress 13 or 23 at the start is not supported; only 0");
    stress[c] = kilo * x;
  }
  set(given, lines, "initial.sigma",
      "[" + exact_text(-stress[0]) + "," + exact_text(-stress[1]) + "," + exact_text(-stress[2]) + "]");
  set(given, lines, "initial.tau", exact_text(stress[3]));
  if (lines.count("the number of state variables", most_states) <= void_ratio_state)
    lines.refuse("needs 7 state variables or more: the void ratio is statev(7)");
  std::string strain;
  for (int s = 0; s < void_ratio_state; ++s) {
    const double x = lines.number("statev(" + std::to_string(s + 1) + ")");
    if (s > 2 && x != 0.0) lines.refuse("a shear of the intergranular strain at the start is not supported; only 0");
    if (s < 3) strain += (strain.empty() ? "[" : ",") + exact_text(0.0 - x);
  }
  set(given, lines, "initial.intergranular_strain", strain + "]");
  set(given, lines, "specimen.void_ratio", exact_text(lines.number("statev(7), the void ratio")));
}

/// One of the six conditions of a step in its variables: the strain's measure and the stress's, with signs.
struct Pair {
  const char *strain, *stress;
  double strain_sign, stress_sign;
};
constexpr std::array<Pair, 6> cartesian{{{"ln_1", "sigma_1", -1, -1},
                                         {"ln_2", "sigma_2", -1, -1},
                                         {"ln_3", "sigma_3", -1, -1},
                                         {"ln_12", "tau", 1, 1},
                                         {"ln_13", "tau_13", 1, 1},
                                         {"ln_23", "tau_23", 1, 1}}};
constexpr std::array<Pair, 3> roscoe{{{"ln_p", "p", 1, 1}, {"ln_q", "q", 1, 1}, {"ln_z", "sigma_2_minus_3", 1, 1}}};

/// A step: which of the six are stresses, and by how much they change.
struct Load {
  std::array<bool, 6> is_stress{};
  std::array<double, 6> change{};
  bool in_roscoe = false;
};

/// The steps that need one number behind their line of increments, or none, and which components are stresses.
struct Shorthand {
  const char* keyword;
  int changed; ///< the component whose change follows; −1: none does
  std::array<bool, 6> is_stress;
  bool in_roscoe;
};
constexpr std::array<Shorthand, 9> shorthands{{
    {"*OedometricE1", 0, {}, false},
    {"*OedometricS1", 0, {true}, false},
    {"*TriaxialE1", 0, {false, true, true}, false},
    {"*TriaxialS1", 0, {true, true, true}, false},
    {"*TriaxialUEq", 1, {}, true},
    {"*TriaxialUq", 1, {false, true}, true},
    {"*PureRelaxation", -1, {}, false},
    {"*PureCreep", -1, {true, true, true, true, true, true}, false},
    {"*UndrainedCreep", -1, {false, true, true, true, true, true}, true},
}};

Load read_linear_load(InputLines& lines) {
  Load load;
  const std::string variables = lines.word("*Cartesian or *Roscoe");
  load.in_roscoe = variables == "*Roscoe";
  if (variables != "*Cartesian" && !load.in_roscoe)
    lines.refuse("the variables '" + variables + "' are not supported; known: *Cartesian, *Roscoe");
  for (std::size_t c = 0; c < 6; ++c) {
    const auto pair = lines.numbers(2, "0 (strain) or 1 (stress), and a change");
    if (pair[0] != 0.0 && pair[0] != 1.0) lines.refuse("a condition begins with 0 (strain) or 1 (stress)");
    load.is_stress[c] = pair[0] == 1.0;
    load.change[c] = pair[1];
  }
  return load;
}

[[noreturn]] void refuse_keyword(const InputLines& lines, const std::string& keyword) {
  std::vector<std::string> names{"*LinearLoad", "*Repetition", "*End"};
  for (const Shorthand& each : shorthands) names.emplace_back(each.keyword);
  std::string known;
  for (const std::string& name : names) known += (known.empty() ? "" : ", ") + name;
  lines.refuse("the keyword '" + keyword + "' is not supported" + did_you_mean(keyword, names) + "; known: " + known);
}

/// One step as a leg. @param keyword its name   @param prefix of its keys
void read_step(CaseFile& given, InputLines& lines, const std::string& keyword, const std::string& prefix) {
  const auto shorthand = std::ranges::find_if(shorthands, [&](const Shorthand& s) { return keyword == s.keyword; });
  if (keyword != "*LinearLoad" && shorthand == shorthands.end()) refuse_keyword(lines, keyword);
  const double duration = lines.numbers(3, "increments, iterations and a time")[2];
  if (duration > 0.0) set(given, lines, prefix + "duration", exact_text(duration));
  Load load;
  if (shorthand == shorthands.end()) {
    load = read_linear_load(lines);
  } else {
    load.is_stress = shorthand->is_stress;
    load.in_roscoe = shorthand->in_roscoe;
    if (shorthand->changed >= 0) load.change[static_cast<std::size_t>(shorthand->changed)] = lines.number("a change");
  }
  for (std::size_t c = 0; c < 6; ++c) {
    const Pair& pair = load.in_roscoe && c < 3 ? roscoe[c] : cartesian[c];
    const double change =
        load.is_stress[c] ? kilo * pair.stress_sign * load.change[c] : pair.strain_sign * load.change[c];
    set(given, lines, prefix + (load.is_stress[c] ? pair.stress : pair.strain), exact_text(change + 0.0));
  }
}

/// A keyword without the blank space around it. Conditions that end a step early stand behind a question mark.
std::string keyword_in(const InputLines& lines, const std::string& line) {
  std::string keyword, rest;
  std::istringstream words(line);
  words >> keyword >> rest;
  if (rest.starts_with('?')) lines.refuse("conditions that end a step early ('?') are not supported");
  return keyword;
}

void read_test(CaseFile& given, const std::filesystem::path& path) {
  InputLines lines(path);
  (void)lines.word("the name of the output"); // ours is output.txt in the folder of results
  int stage = 0;
  for (std::string line; lines.next(line);) {
    const std::string keyword = keyword_in(lines, line);
    if (keyword == "*End") break;
    if (++stage > most_legs) lines.refuse("more than " + std::to_string(most_legs) + " stages");
    const std::string at = stage_prefix(stage);
    set(given, lines, at + "name", toml_text(keyword.substr(keyword.starts_with('*') ? 1 : 0)));
    set(given, lines, at + "relative", "true");
    set(given, lines, at + "spin", "false");
    if (keyword != "*Repetition") {
      read_step(given, lines, keyword, at);
      continue;
    }
    const auto counts = lines.numbers(2, "the number of steps and of repetitions");
    const int legs = lines.as_count(counts[0], "a number of steps", most_legs);
    set(given, lines, at + "repeat",
        std::to_string(lines.as_count(counts[1], "a number of repetitions", most_repeats)));
    for (int leg = 1; leg <= legs; ++leg) read_step(given, lines, lines.word("a step"), leg_prefix(stage, leg));
  }
}

} // namespace

CaseFile import_incremental_driver(const std::filesystem::path& folder, const std::optional<std::string>& model) {
  CaseFile given = CaseFile::empty();
  read_parameters(given, folder / "parameters.inp", model);
  read_initial_conditions(given, folder / "initialconditions.inp");
  read_test(given, folder / "test.inp");
  return given;
}

IncrementalOutput::IncrementalOutput(const std::filesystem::path& path, const Material& law) : file_(path) {
  const auto states = static_cast<std::size_t>(state_components(law.states()));
  const int h = state_column(law.states(), "intergranular_strain"), e = state_column(law.states(), "void_ratio");
  for (int c = 0; c < 6; ++c) columns_.push_back(h < 0 ? -1 : h + c);
  columns_.push_back(e);
  for (int c = 0; c < static_cast<int>(states); ++c)
    if (c != e && (h < 0 || c < h || c >= h + 6)) columns_.push_back(c);
  std::string header = " time(1) time(2)";
  for (const auto& [name, count] :
       {std::pair{" stran(", std::size_t{6}}, {" stress(", 6}, {" statev(", columns_.size()}})
    for (std::size_t i = 1; i <= count; ++i) header += name + std::to_string(i) + ")";
  file_.write(header + "\n");
}

void IncrementalOutput::add(const LawPoint& point) {
  constexpr double root = std::numbers::sqrt2;
  std::string text;
  const auto print = [&](double x) {
    std::array<char, 32> buffer{};
    std::snprintf(buffer.data(), buffer.size(), " %15.8E", x + 0.0);
    text += buffer.data();
  };
  print(point.time);
  print(point.time);
  for (std::size_t c = 0; c < 6; ++c) print(c < 3 ? point.strain.m[c] : root * point.strain.m[c]);
  for (std::size_t c = 0; c < 6; ++c) print(point.stress.m[c] / (c < 3 ? kilo : root * kilo));
  for (std::size_t c = 0; c < columns_.size(); ++c) {
    const double x = columns_[c] < 0 ? 0.0 : point.state[static_cast<std::size_t>(columns_[c])];
    print(c >= 3 && c < 6 ? root * x : x); // shears of the intergranular strain, as of strain
  }
  file_.write(text + "\n");
}

} // namespace riedel
