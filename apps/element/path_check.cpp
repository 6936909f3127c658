#include "apps/element/path_check.hpp"

#include "apps/element/path_keys.hpp"
#include "core/base/error.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <map>

namespace riedel {

namespace {

/// The keys that a finding about a leg points to: first one that is given.
std::vector<std::string> keys_of(const Values& values, int stage, int leg) {
  std::vector<std::string> given, other;
  for (const std::string& prefix : {leg_prefix(stage, leg), stage_prefix(stage)})
    for (const Measure& measure : measures()) {
      const std::string key = prefix + measure.name;
      const bool says = values.has(key) && values.at(key) != Value(std::string(free_word));
      (says ? given : other).push_back(key);
    }
  given.insert(given.end(), other.begin(), other.end());
  return given;
}

/// A deformation gradient excludes other conditions, and its determinant is positive.
bool check_deformation(const Values& values, const PathLeg& leg, const std::string& stage, const std::string& own,
                       std::vector<Finding>& errors) {
  const bool in_leg = !values.numbers(own + "deformation_gradient").empty();
  const std::string key = (in_leg ? own : stage) + "deformation_gradient";
  if (values.numbers(key).empty()) return false;
  if (!leg.deformation)
    errors.push_back({{key}, "has " + std::to_string(values.numbers(key).size()) + " numbers; allowed: 9"});
  else if (!(leg.deformation->determinant() > 0.0))
    errors.push_back({{key}, "has a determinant that is not positive; allowed: a positive one"});
  else if (!leg.prescriptions.empty())
    errors.push_back(
        {{key}, "prescribes the whole motion; the leg also prescribes " + leg.prescriptions.front().measure->name});
  return true;
}

/// A sine needs a prescribed measure to which it is added.
void check_waves(const Values& values, const PathLeg& leg, const std::string& prefix, std::vector<Finding>& errors) {
  for (const Measure& measure : measures()) {
    if (!measure.can_be_prescribed || values.number(prefix + swing_key(measure.name)) == 0.0) continue;
    if (std::ranges::find(leg.prescriptions, &measure, &Prescription::measure) == leg.prescriptions.end())
      errors.push_back({{prefix + swing_key(measure.name)},
                        "the leg does not prescribe " + measure.name + "; allowed beside " + measure.name +
                            " = \"hold\" or a number"});
  }
}

void check_leg(const PathLeg& leg, const std::vector<std::string>& keys, std::vector<Finding>& errors) {
  if (leg.prescriptions.size() == 6) return;
  std::string given;
  for (const Prescription& each : leg.prescriptions) given += (given.empty() ? "" : ", ") + each.measure->name;
  errors.push_back({keys, "a leg needs six conditions, and this one has " + std::to_string(leg.prescriptions.size()) +
                              ": " + given + " (a shear that is not named is kept constant)"});
}

bool check_limits(const Values& values, std::vector<Finding>& errors) {
  const std::size_t before = errors.size();
  for (int stage = 1; values.has(stage_prefix(stage) + "until"); ++stage) {
    const std::string key = stage_prefix(stage) + "until";
    try {
      if (!values.text(key).empty()) (void)parse_stop(values.text(key));
    } catch (const InputError& error) { errors.push_back({{key}, error.what()}); }
  }
  return errors.size() == before;
}

/// The value of each measure of strain along a path, as far as it is known [-].
using Known = std::map<const Measure*, double>;

/// Minimum strain of a leg.
double min_strain(const PathLeg& leg, Known& known) {
  double minimum = 0.0;
  Known after;
  for (const auto& [measure, target, swing, phase] : leg.prescriptions) {
    if (measure->unit != "-") continue;
    minimum = std::max(minimum, 2.0 * std::abs(swing));
    const auto before = known.find(measure);
    if (leg.relative && target) minimum = std::max(minimum, std::abs(*target));
    if (leg.relative) continue;
    if (before != known.end() && target) minimum = std::max(minimum, std::abs(*target - before->second));
    if (target || before != known.end()) after[measure] = target ? *target : before->second;
  }
  known = std::move(after);
  return minimum;
}

/// Minimum number of rows of a round.
double min_rows(const PathStage& stage, double every, Known& known) {
  double rows = 0.0;
  for (const PathLeg& leg : stage.legs) rows += std::max(1.0, min_strain(leg, known) / every);
  return rows;
}

} // namespace

void check_rows(double every, const ElementPath& path, std::vector<Finding>& errors) {
  const double maximum = max_element_rows;
  Known known;
  for (const Measure& measure : measures()) known[&measure] = 0.0;
  double rows = 0.0;
  for (std::size_t s = 0; s < path.stages.size(); ++s) {
    const PathStage& stage = path.stages[s];
    const double first = min_rows(stage, every, known), others = min_rows(stage, every, known);
    if (stage.until)
      known.clear();
    else
      rows += first + static_cast<double>(stage.repeat - 1) * others;
    if (rows <= maximum) continue;
    const std::string repeat = stage_prefix(static_cast<int>(s + 1)) + "repeat";
    errors.push_back({{stage.repeat > 1 ? repeat : "output.every_strain"},
                      "the path has at least " + short_text(rows) + " rows up to here; allowed: at most " +
                          std::to_string(max_element_rows) + ", with fewer rounds or a larger output.every_strain"});
    return;
  }
}

void check_path(const ElementCase& given, std::vector<Finding>& errors) {
  const Values& values = given.keys;
  if (!check_limits(values, errors)) return;
  const ElementPath path = element_path(given);
  if (path.stages.empty())
    errors.push_back({{"test"}, "a path needs at least one [[stage]]; docs/howto/element_paths.md has examples"});
  for (std::size_t s = 0; s < path.stages.size(); ++s)
    for (std::size_t l = 0; l < path.stages[s].legs.size(); ++l) {
      const int stage = static_cast<int>(s + 1), number = static_cast<int>(l + 1);
      const PathLeg& leg = path.stages[s].legs[l];
      const bool alone = !values.has(leg_prefix(stage, number) + "duration"); // the stage is its only leg
      const std::string own = alone ? stage_prefix(stage) : leg_prefix(stage, number);
      check_waves(values, leg, own, errors);
      if (!check_deformation(values, leg, stage_prefix(stage), own, errors))
        check_leg(leg, keys_of(values, stage, number), errors);
    }
  check_rows(given.every_strain, path, errors);
}

} // namespace riedel
