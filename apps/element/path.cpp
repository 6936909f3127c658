#include "apps/element/path.hpp"

#include "apps/element/path_keys.hpp"
#include "core/base/error.hpp"
#include "core/io/units.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>

namespace riedel {

namespace {

constexpr std::optional<double> hold = std::nullopt;

Sym<double> isotropic(double pressure) { return -pressure * Sym<double>::identity(); }

/// The conditions of a named test: the driven measure goes to the final strain in one leg, the others are constant.
ElementPath named_path(const ElementCase& given) {
  const ElementTest& test = *given.named;
  const double strain = given.loading.final_strain;
  ElementPath path{.stress = isotropic(given.loading.pressure),
                   .stages = {{.name = test.name, .legs = {PathLeg{}}}},
                   .friction = test.friction};
  PathStage& stage = path.stages.front();
  PathLeg& leg = stage.legs.front();
  const auto prescribe = [&](const std::string& measure) {
    leg.prescriptions.push_back({&find_measure(measure), measure == test.driven ? std::optional(strain) : hold});
  };
  for (const char* shear : {"gamma", "gamma_13", "gamma_23"}) prescribe(shear);
  for (const std::string& measure : test.normal) prescribe(measure);
  leg.duration = strain / given.loading.rate;
  if (given.loading.limit)
    stage.until = Stop{.measure = &find_measure(test.limit_measure), .above = true, .limit = *given.loading.limit};
  return path;
}

/// A key of a leg, or else of its stage.
const Value& wish(const Values& v, const std::string& stage, const std::string& leg, const std::string& name) {
  const bool in_leg = v.has(leg + name) && v.at(leg + name) != Value(std::string(free_word));
  return v.at((in_leg ? leg : stage) + name);
}

/// The sine of a measure, in the leg or else in its stage.
void add_wave(Prescription& to, const Values& v, const std::string& stage, const std::string& leg) {
  const std::string name = to.measure->name;
  const std::string& from = v.number(leg + swing_key(name)) != 0.0 ? leg : stage;
  to.swing = v.number(from + swing_key(name));
  to.phase = v.number(from + phase_key(name)) * std::numbers::pi / 180.0;
}

std::optional<Mat<3>> given_deformation(const Values& v, const std::string& stage, const std::string& leg) {
  const bool in_leg = !v.numbers(leg + "deformation_gradient").empty();
  const std::vector<double>& F = v.numbers((in_leg ? leg : stage) + "deformation_gradient");
  if (F.size() != 9) return std::nullopt; // reported by the check of the path
  return Mat<3>(Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>>(F.data()));
}

PathLeg given_leg(const Values& v, const std::string& stage, const std::string& leg) {
  PathLeg result{.prescriptions = {},
                 .deformation = given_deformation(v, stage, leg),
                 .relative = v.flag(stage + "relative"),
                 .duration = v.number(leg + "duration"),
                 .spin = v.flag(stage + "spin")};
  const auto given = [&](const std::string& name) {
    return wish(v, stage, leg, name) != Value(std::string(free_word));
  };
  for (const Measure& measure : measures()) {
    if (!measure.can_be_prescribed || !given(measure.name)) continue;
    const Value& value = wish(v, stage, leg, measure.name);
    const bool fixed = std::holds_alternative<std::string>(value);
    result.prescriptions.push_back({&measure, fixed ? hold : std::optional(std::get<double>(value))});
    add_wave(result.prescriptions.back(), v, stage, leg);
  }
  if (result.deformation) return result; // no shear is kept constant
  for (const std::array<const char*, 3>& shear :
       {std::array{"gamma", "tau", "ln_12"}, {"gamma_13", "tau_13", "ln_13"}, {"gamma_23", "tau_23", "ln_23"}})
    if (std::ranges::none_of(shear, given)) result.prescriptions.push_back({&find_measure(shear.front()), hold});
  return result;
}

ElementPath given_path(const ElementCase& given) {
  const Values& v = given.keys;
  const PoreWater water{.bulk_modulus = given.initial.water_bulk_modulus,
                        .initial_pressure = given.initial.pore_pressure};
  ElementPath path{.stress = given.initial.total_stress + water.initial_pressure * Sym<double>::identity(),
                   .stages = {},
                   .water = water};
  for (int s = 1; v.has(stage_prefix(s) + "repeat"); ++s) {
    const std::string at = stage_prefix(s);
    PathStage& stage = path.stages.emplace_back();
    stage.name = v.text(at + "name").empty() ? "stage " + std::to_string(s) : v.text(at + "name");
    stage.repeat = v.integer(at + "repeat");
    if (!v.text(at + "until").empty()) stage.until = parse_stop(v.text(at + "until"));
    for (int l = 1; v.has(leg_prefix(s, l) + "duration"); ++l) stage.legs.push_back(given_leg(v, at, leg_prefix(s, l)));
    if (stage.legs.empty()) stage.legs.push_back(given_leg(v, at, at));
  }
  return path;
}

/// A number in the measure's own unit, or a text with a unit.
double limit_in(const std::string& text, const std::string& unit) {
  double x = 0.0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), x);
  const bool plain = error == std::errc{} && end == text.data() + text.size() && std::isfinite(x);
  return plain ? x : read_quantity(text, unit);
}

} // namespace

Stop parse_stop(const std::string& text) {
  const std::size_t sign = text.find_first_of("<>");
  if (sign == std::string::npos)
    throw InputError("'" + text + "' is no limit; allowed: a measure, < or >, and a number, such as \"p < 20 kPa\"");
  const auto trimmed = [](std::string word) {
    word.erase(0, word.find_first_not_of(' '));
    word.erase(word.find_last_not_of(' ') + 1);
    return word;
  };
  const Measure& measure = find_measure(trimmed(text.substr(0, sign)));
  return {
      .measure = &measure, .above = text[sign] == '>', .limit = limit_in(trimmed(text.substr(sign + 1)), measure.unit)};
}

ElementPath element_path(const ElementCase& given) {
  return given.named == nullptr ? given_path(given) : named_path(given);
}

} // namespace riedel
