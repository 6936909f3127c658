#include "apps/path_keys.hpp"

#include "apps/element_path.hpp"
#include "apps/material_keys.hpp"
#include "core/base/error.hpp"

#include <charconv>

namespace riedel {

namespace {

Keys measure_keys(const std::string& prefix) {
  Keys keys;
  for (const Measure& measure : measures())
    if (measure.can_be_prescribed)
      keys.push_back({prefix + measure.name,
                      std::string(free_word),
                      measure.unit,
                      {},
                      measure.doc,
                      {std::string(free_word), std::string(hold_word)}});
  return keys;
}

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

void check_leg(const PathLeg& leg, const std::vector<std::string>& keys, std::vector<Finding>& errors) {
  if (leg.prescriptions.size() == 6) return;
  std::string given;
  for (const Prescription& each : leg.prescriptions) given += (given.empty() ? "" : ", ") + each.measure->name;
  errors.push_back({keys, "a leg needs six conditions, and this one has " + std::to_string(leg.prescriptions.size()) +
                              ": " + given + " (a shear that is not named is held)"});
}

/// Number of tables in a list, such as "stage" or "stage.2.leg".
/// @throws InputError for a number behind a gap, and for more of them than a case can mean
int tables_in(const CaseFile& given, const std::string& list) {
  constexpr int most = 1000;
  const int count = given.count(list);
  for (const std::string& name : given.names_in(list)) {
    int number = 0;
    const std::string rest = name.substr(list.size() + 1);
    const auto [end, error] = std::from_chars(rest.data(), rest.data() + rest.size(), number);
    if (end == rest.data()) continue; // no number: an unknown key
    if (error != std::errc{} || number < 1 || number > count)
      throw InputError(given.place(name) + ": there is no " + list + "." + std::to_string(count + 1) +
                       "; allowed: numbers from 1 without a gap");
    if (number > most)
      throw InputError(given.place(name) + ": is one of " + std::to_string(count) + "; allowed: at most " +
                       std::to_string(most));
  }
  return count;
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

} // namespace

std::string stage_prefix(int stage) { return "stage." + std::to_string(stage) + "."; }
std::string leg_prefix(int stage, int leg) { return stage_prefix(stage) + "leg." + std::to_string(leg) + "."; }

Keys stage_keys(const std::string& prefix) {
  Keys keys{
      {prefix + "name", "", "", {}, "name of the stage, for messages"},
      {prefix + "repeat", std::int64_t{1}, "-", between(1, 1e6), "times that the legs are run through"},
      {prefix + "until", "", "", {}, "what ends the stage early, such as \"p < 20 kPa\"; empty: nothing"},
      {prefix + "relative", false, "", {}, "targets are changes from the start of each leg"},
      {prefix + "spin",
       true,
       "",
       {},
       "a shear turns the normals of the sheared planes; false: no spin, as with small strains"},
      {prefix + "duration", 1.0, "s", more_than(0), "time that a leg takes; of no effect where the law knows no rate"}};
  append(keys, measure_keys(prefix));
  return keys;
}

Keys leg_keys(const std::string& prefix) {
  Keys keys{{prefix + "duration", 1.0, "s", more_than(0), "time that the leg takes"}};
  append(keys, measure_keys(prefix));
  return keys;
}

Keys path_keys(const CaseFile& given) {
  Keys keys;
  const int stages = tables_in(given, "stage");
  for (int stage = 1; stage <= stages; ++stage) {
    const std::string prefix = stage_prefix(stage);
    append(keys, stage_keys(prefix));
    const int legs = tables_in(given, prefix + "leg");
    for (int leg = 1; leg <= legs; ++leg) append(keys, leg_keys(leg_prefix(stage, leg)));
  }
  return keys;
}

void check_path(const Values& values, std::vector<Finding>& errors) {
  if (!check_limits(values, errors)) return;
  const ElementPath path = element_path(values);
  if (path.stages.empty())
    errors.push_back({{"test"}, "a path needs at least one [[stage]]; docs/howto/element_paths.md has examples"});
  for (std::size_t s = 0; s < path.stages.size(); ++s)
    for (std::size_t l = 0; l < path.stages[s].legs.size(); ++l)
      check_leg(path.stages[s].legs[l], keys_of(values, static_cast<int>(s + 1), static_cast<int>(l + 1)), errors);
}

} // namespace riedel
