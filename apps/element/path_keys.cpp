#include "apps/element/path_keys.hpp"

#include "core/base/error.hpp"
#include "core/case/material_keys.hpp"
#include "materials/element/measures.hpp"

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
  keys.push_back({prefix + "deformation_gradient",
                  std::vector<double>{},
                  "-",
                  {},
                  "F from the start of the leg to its end, row by row, reached on a straight line; instead of measures",
                  {},
                  true});
  return keys;
}

/// Number of tables in a list, such as "stage" or "stage.2.leg".
/// @throws InputError for a number after a gap, and for more tables than are allowed
int tables_in(const CaseFile& given, const std::string& list) {
  constexpr int maximum = 1000;
  const int count = given.count(list);
  for (const std::string& name : given.names_in(list)) {
    int number = 0;
    const std::string rest = name.substr(list.size() + 1);
    const auto [end, error] = std::from_chars(rest.data(), rest.data() + rest.size(), number);
    if (end == rest.data()) continue; // no number: an unknown key
    if (error != std::errc{} || number < 1 || number > count)
      throw InputError(given.place(name) + ": there is no " + list + "." + std::to_string(count + 1) +
                       "; allowed: numbers from 1 without a gap");
    if (number > maximum)
      throw InputError(given.place(name) + ": is one of " + std::to_string(count) + "; allowed: at most " +
                       std::to_string(maximum));
  }
  return count;
}

} // namespace

std::string stage_prefix(int stage) { return "stage." + std::to_string(stage) + "."; }
std::string leg_prefix(int stage, int leg) { return stage_prefix(stage) + "leg." + std::to_string(leg) + "."; }

Keys stage_keys(const std::string& prefix) {
  Keys keys{
      {prefix + "name", "", "", {}, "name of the stage, for messages"},
      {prefix + "repeat", std::int64_t{1}, "-", between(1, 1e6), "number of times that the legs are run"},
      {prefix + "until", "", "", {}, "what ends the stage early, such as \"p < 20 kPa\"; empty: nothing"},
      {prefix + "relative", false, "", {}, "targets are changes from the start of each leg"},
      {prefix + "spin",
       true,
       "",
       {},
       "a shear turns the normals of the sheared planes; false: no spin, as with small strains"},
      {prefix + "duration", 1.0, "s", more_than(0), "duration of a leg; without effect for a rate-independent law"}};
  append(keys, measure_keys(prefix));
  return keys;
}

std::string swing_key(const std::string& measure) { return measure + "_swing"; }
std::string phase_key(const std::string& measure) { return measure + "_phase"; }

Keys wave_keys(const std::string& prefix) {
  Keys keys;
  for (const Measure& measure : measures()) {
    if (!measure.can_be_prescribed) continue;
    keys.push_back({prefix + swing_key(measure.name),
                    0.0,
                    measure.unit,
                    {},
                    "amplitude of one period of a sine over the leg, added to " + measure.name});
    keys.push_back({prefix + phase_key(measure.name), 0.0, "deg", {}, "angle of that sine at the start of the leg"});
  }
  return keys;
}

Keys leg_keys(const std::string& prefix) {
  Keys keys{{prefix + "duration", 1.0, "s", more_than(0), "duration of the leg"}};
  append(keys, measure_keys(prefix));
  return keys;
}

Keys path_keys(const CaseFile& given) {
  Keys keys;
  const int stages = tables_in(given, "stage");
  for (int stage = 1; stage <= stages; ++stage) {
    const std::string prefix = stage_prefix(stage);
    append(keys, stage_keys(prefix));
    append(keys, wave_keys(prefix));
    const int legs = tables_in(given, prefix + "leg");
    for (int leg = 1; leg <= legs; ++leg) {
      append(keys, leg_keys(leg_prefix(stage, leg)));
      append(keys, wave_keys(leg_prefix(stage, leg)));
    }
  }
  return keys;
}

} // namespace riedel
