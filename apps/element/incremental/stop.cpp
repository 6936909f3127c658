#include "apps/element/incremental/stop.hpp"

#include "core/base/parameters.hpp"

#include <algorithm>
#include <map>
#include <numbers>

namespace riedel {

namespace {

/// A measure of a path, and what it is multiplied by to give the file's component.
struct Component {
  std::string measure;
  double factor;
  bool of_stress;
};

const std::map<std::string, Component, std::less<>>& components() {
  static const std::map<std::string, Component, std::less<>> all{
      {"s1", {"sigma_1", -1, true}}, {"s2", {"sigma_2", -1, true}},
      {"s3", {"sigma_3", -1, true}}, {"s12", {"tau", 1, true}},
      {"s13", {"tau_13", 1, true}},  {"s23", {"tau_23", 1, true}},
      {"p", {"p", 1, true}},         {"P", {"p", std::numbers::sqrt3, true}},
      {"e1", {"ln_1", -1, false}},   {"e2", {"ln_2", -1, false}},
      {"e3", {"ln_3", -1, false}},   {"g12", {"ln_12", 1, false}},
      {"g13", {"ln_13", 1, false}},  {"g23", {"ln_23", 1, false}},
      {"ev", {"ln_p", 1, false}},    {"eP", {"ln_p", 1 / std::numbers::sqrt3, false}}};
  return all;
}

std::string without_blanks(std::string text) {
  std::erase_if(text, [](char c) { return c == ' ' || c == '\t' || c == '\r'; });
  return text;
}

} // namespace

std::string incremental_stop(const InputLines& at, const std::string& condition, double stress_unit) {
  std::string known;
  for (const auto& [name, component] : components()) known += (known.empty() ? "" : ", ") + name;
  const std::size_t sign = std::min(condition.find_first_of("<>"), condition.size());
  std::string left = without_blanks(condition.substr(0, sign));
  double factor = 1.0;
  if (left.starts_with('-')) {
    factor = -1.0;
    left.erase(0, 1);
  }
  if (const std::size_t times = left.find('*'); times != std::string::npos) {
    factor *= at.numbers_in(left.substr(0, times), 1, "a factor").front();
    left.erase(0, times + 1);
  }
  const auto component = components().find(left);
  if (sign == condition.size() || component == components().end() || factor == 0.0)
    at.refuse("the condition '" + condition +
              "' that ends a step early is not supported; known: [FACTOR*]COMPONENT, < "
              "or >, and a number, with a component of " +
              known);
  const double limit = at.numbers_in(condition.substr(sign + 1), 1, "a limit").front();
  factor *= component->second.factor;
  const bool above = (condition[sign] == '>') == (factor > 0.0);
  const bool stress = component->second.of_stress;
  return component->second.measure + (above ? " > " : " < ") +
         exact_text(limit / factor * (stress ? stress_unit : 1.0)) + (stress ? " Pa" : "");
}

} // namespace riedel
