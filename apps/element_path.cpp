#include "apps/element_path.hpp"

#include "apps/path_keys.hpp"
#include "core/base/error.hpp"
#include "core/io/units.hpp"

#include <algorithm>

namespace riedel {

namespace {

using Wishes = std::vector<std::pair<const char*, std::optional<double>>>;
constexpr std::optional<double> hold = std::nullopt;

PathLeg leg_of(const Wishes& wishes) {
  PathLeg leg;
  for (const auto& [name, target] : wishes) leg.prescriptions.push_back({&find_measure(name), target});
  return leg;
}

Sym<double> isotropic(double pressure) { return -pressure * Sym<double>::identity(); }

/// The tests of the paper (oedometer, triaxial compression, shear with free dilatancy) and plane strain compression.
ElementPath named_path(const Values& v, const std::string& test) {
  const double strain = v.number("loading.final_strain");
  ElementPath path{.stress = {}, .stages = {{.name = test, .legs = {}}}, .friction = Friction::in_plane};
  PathStage& stage = path.stages.front();
  Wishes wishes{{"gamma", hold}, {"gamma_13", hold}, {"gamma_23", hold}};
  if (test == "oedometer") {
    path.stress = isotropic(v.number("loading.initial_pressure"));
    wishes.insert(wishes.end(), {{"eps_1", strain}, {"eps_2", hold}, {"eps_3", hold}});
    stage.until = Stop{.measure = &find_measure("sigma_1"), .above = true, .limit = v.number("loading.final_stress")};
  } else if (test == "shear") {
    path.stress = isotropic(v.number("loading.normal_stress"));
    wishes = {{"gamma", strain}, {"gamma_13", hold}, {"gamma_23", hold},
              {"eps_1", hold},   {"sigma_2", hold},  {"eps_3", hold}};
    path.friction = Friction::on_planes;
  } else {
    path.stress = isotropic(v.number("loading.confining_pressure"));
    wishes.insert(wishes.end(),
                  {{"eps_1", strain}, {"sigma_2", hold}, {test == "biaxial" ? "eps_3" : "sigma_3", hold}});
  }
  stage.legs.push_back(leg_of(wishes));
  stage.legs.front().duration = strain / v.number("loading.rate");
  return path;
}

/// A key of a leg, or else of its stage.
const Value& wish(const Values& v, const std::string& stage, const std::string& leg, const std::string& name) {
  const bool in_leg = v.has(leg + name) && v.at(leg + name) != Value(std::string(free_word));
  return v.at((in_leg ? leg : stage) + name);
}

PathLeg given_leg(const Values& v, const std::string& stage, const std::string& leg) {
  PathLeg result{.prescriptions = {},
                 .relative = v.flag(stage + "relative"),
                 .duration = v.number(leg + "duration"),
                 .spin = v.flag(stage + "spin")};
  const auto given = [&](const std::string& name) {
    return wish(v, stage, leg, name) != Value(std::string(free_word));
  };
  for (const Measure& measure : measures()) {
    if (!measure.can_be_prescribed || !given(measure.name)) continue;
    const Value& value = wish(v, stage, leg, measure.name);
    const bool held = std::holds_alternative<std::string>(value);
    result.prescriptions.push_back({&measure, held ? hold : std::optional(std::get<double>(value))});
  }
  for (const std::array<const char*, 3>& shear :
       {std::array{"gamma", "tau", "ln_12"}, {"gamma_13", "tau_13", "ln_13"}, {"gamma_23", "tau_23", "ln_23"}})
    if (std::ranges::none_of(shear, given)) result.prescriptions.push_back({&find_measure(shear.front()), hold});
  return result;
}

ElementPath given_path(const Values& v) {
  const std::vector<double>& sigma = v.numbers("initial.sigma");
  ElementPath path{.stress = {{-sigma[0], -sigma[1], -sigma[2], std::numbers::sqrt2 * v.number("initial.tau"), 0, 0}},
                   .stages = {}};
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
  return {.measure = &measure,
          .above = text[sign] == '>',
          .limit = read_quantity(trimmed(text.substr(sign + 1)), measure.unit)};
}

Leg leg_from(const PathLeg& leg, const LawPoint& point) {
  Leg result{.conditions = {},
             .duration = leg.duration,
             .motion = leg.spin ? Leg::Motion::simple_shear : Leg::Motion::no_spin};
  for (std::size_t c = 0; c < result.conditions.size(); ++c) {
    const auto& [measure, target] = leg.prescriptions.at(c);
    const double now = measure->of(point), start = leg.relative || !target ? now : 0.0;
    result.conditions[c] = condition(*measure, start + target.value_or(0.0));
  }
  return result;
}

ElementPath element_path(const Values& values) {
  const std::string& test = values.text("test");
  return test == "path" ? given_path(values) : named_path(values, test);
}

} // namespace riedel
