#include "apps/biaxial/sense.hpp"

#include "apps/biaxial/patch.hpp"
#include "core/case/outlook_text.hpp"

#include <algorithm>
#include <cmath>

namespace riedel {

namespace {

std::string number(double x) { return short_text(x, 4); }

/// A number in an everyday unit: 1.5 m, 23 mm, 50 kPa.
std::string metres(double x) { return x < 1.0 ? number(1e3 * x) + " mm" : number(x) + " m"; }
std::string pascals(double p) {
  return p < 1e3 ? number(p) + " Pa" : p < 1e6 ? number(1e-3 * p) + " kPa" : number(1e-6 * p) + " MPa";
}

/// A count to three digits.
std::int64_t in_thousandths(double x) {
  const double unit = std::pow(10.0, std::max(0.0, std::floor(std::log10(std::max(x, 1.0))) - 2.0));
  return std::llround(std::round(x / unit) * unit);
}

/// The input of the checks.
struct Sense {
  const BiaxialCase& v;
  const Material& law;
  ExpectedWork expected;
  double width, height, wave_speed;
  Diagnostics& found;

  void warn(std::vector<std::string> keys, std::string text) const {
    found.warnings.push_back({std::move(keys), std::move(text)});
  }
  void refuse(std::vector<std::string> keys, std::string text) const {
    found.errors.push_back({std::move(keys), std::move(text)});
  }
  [[nodiscard]] std::string value(const std::string& key, const std::string& unit) const {
    return exact_text(v.keys.number(key)) + " " + unit;
  }
};

void check_lengths(const Sense& s) {
  const double minimum = std::min(s.width, s.height), maximum = std::max(s.width, s.height);
  const std::string l = "nonlocal.length", unit = "; a number is in metres, a text may have a unit: ";
  const double l_c = s.v.keys.number(l);
  if (l_c > maximum)
    s.refuse({l, "specimen.width", "specimen.height"},
             s.value(l, "m") + " is " + number(l_c / s.width) + " times the width of the specimen, " + metres(s.width) +
                 "; allowed: at most " + metres(maximum) + unit + "\"1.5 mm\"");
  else if (3.0 * l_c > minimum)
    s.warn({l, "specimen.width", "specimen.height"},
           s.value(l, "m") + ": the average extends 3 l_c = " + metres(3.0 * l_c) +
               " to each side, across the whole specimen of " + metres(minimum));
  for (const char* edge : {"specimen.width", "specimen.height"})
    if (const double x = s.v.keys.number(edge); x > 10.0 || x < 1e-3)
      s.warn({edge}, "a specimen of " + metres(x) + unit + "\"40 mm\"");
  const std::string correlation = "imperfection.correlation_length";
  const double lambda = s.v.keys.number(correlation);
  if (s.v.imperfection.deviation > 0.0 && lambda > maximum)
    s.warn({correlation, "specimen.height"}, s.value(correlation, "m") + " is longer than the specimen, " +
                                                 metres(maximum) + ": the field hardly varies in it" + unit +
                                                 "\"5 mm\"");
}

void check_loading(const Sense& s) {
  constexpr double hardly = 0.02; // of the wave speed
  const std::string p = "loading.confining_pressure", speed = "loading.speed", gravity = "loading.gravity";
  const double pressure = s.v.keys.number(p), v = s.v.keys.number(speed);
  std::vector<double> state = s.law.initial_state();
  if (const int e = state_column(s.law.states(), "void_ratio"); e >= 0)
    state[static_cast<std::size_t>(e)] = s.v.specimen.void_ratio;
  const double weight = s.law.density(state) * s.v.keys.number(gravity) * s.height;
  if (pressure < weight)
    s.warn({p, gravity, "specimen.height"},
           pascals(pressure) + " is less than the specimen's own weight at its foot, " + pascals(weight) +
               "; a number is in Pa, a text may have a unit: \"50 kPa\"");
  if (pressure > 1e8) s.warn({p}, pascals(pressure) + " crushes sand grains, which begins at about 10 MPa");
  if (v >= s.wave_speed)
    s.refuse({speed}, s.value(speed, "m/s") + " is faster than the waves in the specimen, " + number(s.wave_speed) +
                          " m/s; allowed: less than that, and less than 2 % of it for a quasi-static test");
  else if (v > hardly * s.wave_speed)
    s.warn({speed}, s.value(speed, "m/s") + " is " + number(100.0 * v / s.wave_speed) +
                        " % of the speed of waves in the specimen, " + number(s.wave_speed) +
                        " m/s: above 2 % a test is hardly quasi-static");
  if (s.wave_speed < 1.0 || s.wave_speed > 2e4)
    s.warn({"material.model"}, "waves travel at " + number(s.wave_speed) +
                                   " m/s in the specimen at the start: a stiffness in another unit?");
}

void check_times(const Sense& s, const CaseFile& given) {
  const std::string ramp = "loading.ramp_time", step = "time.step";
  const double at_speed = s.v.loading.final_strain * s.height / s.v.loading.speed;
  const auto names = given.names_in("loading");
  const bool is_given = std::ranges::find(names, ramp) != names.end();
  if (is_given && s.v.keys.number(ramp) > std::max(at_speed, 5e-3))
    s.warn({ramp, "loading.speed", "loading.final_strain"},
           s.value(ramp, "s") + " is " + number(s.v.keys.number(ramp) / at_speed) +
               " times the duration of the test at full speed, " + number(at_speed) +
               " s: the speed still rises at its end");
  constexpr double absurd = 20.0;
  if (!s.v.keys.is_text(step) && s.v.keys.number(step) > absurd * s.expected.limit)
    s.refuse({step}, s.value(step, "s") + " is " + number(s.v.keys.number(step) / s.expected.limit) +
                         " times the stable time step, " + number(s.expected.limit) +
                         " s at the start; allowed: less than that, or \"auto\"");
}

void check_filter(const Sense& s) {
  const std::string rate = "time.stress_filter";
  if (!s.v.keys.is_text(rate) && s.v.keys.number(rate) * s.expected.step > 1.0)
    s.refuse({rate}, s.value(rate, "1/s") + " is more than one per time step of " + number(s.expected.step) +
                         " s; allowed: up to " + number(1.0 / s.expected.step) + " 1/s, and 0 for none");
}

void check_grid(const Sense& s) {
  const std::string cells = "grid.cells";
  const auto& n = s.v.grid.cells;
  const double h = s.width / static_cast<double>(n[0]), v = s.height / static_cast<double>(n[1]);
  const double aspect = std::max(h / v, v / h);
  if (aspect > 10.0)
    s.warn({cells}, "cells of " + metres(h) + " by " + metres(v) + " are " + number(aspect) +
                        " times as long as wide; the specimen is " + metres(s.width) + " by " + metres(s.height));
  if (std::min(h, v) < 1e-4)
    s.warn({cells}, "cells of " + metres(h) + " by " + metres(v) + " are smaller than sand grains, about 0.5 mm");
  if (const SpecimenPatch patch(s.v); !patch.is_empty() && !patch.holds_a_point(s.v))
    s.warn({"imperfection.size", "imperfection.centre", cells},
           "the patch of " + metres(patch.size[0]) + " by " + metres(patch.size[1]) +
               " contains the centre of no point: there is no patch; points are " +
               metres(h / static_cast<double>(s.v.specimen.points_per_cell)) + " by " +
               metres(v / static_cast<double>(s.v.specimen.points_per_cell)) + " apart");
}

void check_output(const Sense& s) {
  const double strain = s.v.loading.final_strain;
  const double rows = strain / s.v.output.every_strain,
               frames = s.v.output.vtk ? strain / s.v.output.frames_every_strain : 0.0;
  if (std::min(rows, s.expected.steps) > 1e6)
    s.warn({"output.every_strain"}, short_text(std::min(rows, s.expected.steps)) + " rows of history.csv");
  if (std::min(frames, s.expected.steps) > 1e4)
    s.warn({"output.frames_every_strain"}, short_text(std::min(frames, s.expected.steps)) + " frames, each of " +
                                               number(s.expected.points) + " points");
}

/// The first given key of those that determine the work.
std::string key_of_work(const CaseFile& given) {
  for (const std::string key : {"grid.cells", "specimen.points_per_cell", "time.step", "time.cfl", "loading.speed",
                                "loading.final_strain", "nonlocal.length"}) {
    const std::vector<std::string> names = given.names_in(key.substr(0, key.find('.')));
    if (std::ranges::find(names, key) != names.end()) return key;
  }
  return "grid.cells";
}

void check_work(const Sense& s, const CaseFile& given) {
  constexpr double day = 86400.0;
  if (s.expected.seconds() > day)
    s.warn({key_of_work(given)}, "the run takes more than a day: " + expected_text(s.expected));
}

} // namespace

ExpectedWork expected_work_of(const BiaxialCase& values, const Catalogue& catalogue) {
  const auto law = catalogue.materials.find(values.material.model).make(values.material.parameters);
  return expected_work(values, wave_speeds(values, *law));
}

std::string expected_text(const ExpectedWork& e) {
  return std::to_string(std::llround(e.points)) + " points, " + std::to_string(in_thousandths(e.steps)) + " steps of " +
         short_text(e.step) + " s, about " + span_text(e.seconds()) + " on one thread";
}

std::vector<Finding> time_step_doubts(const BiaxialCase& v, const ExpectedWork& expected) {
  if (v.keys.is_text("time.step") || v.keys.number("time.step") <= expected.limit) return {};
  return {{{"time.step"},
           exact_text(v.keys.number("time.step")) + " s is over the stable limit, " + short_text(expected.limit) +
               " s at the start: the run may become unstable, or give wrong results without warning"}};
}

void check_sense(const CaseFile& given, const BiaxialCase& v, const Catalogue& catalogue, Diagnostics& found) {
  if (!found.errors.empty()) return;
  std::unique_ptr<Material> law;
  try {
    law = catalogue.materials.find(v.material.model).make(v.material.parameters);
  } catch (const std::runtime_error&) { return; } // reported with its place when the run makes it
  const WaveSpeeds speeds = wave_speeds(v, *law);
  const Sense sense{v, *law, expected_work(v, speeds), v.specimen.width, v.specimen.height, speeds.at_start, found};
  check_lengths(sense);
  check_loading(sense);
  check_times(sense, given);
  check_filter(sense);
  check_grid(sense);
  check_output(sense);
  check_work(sense, given);
}

} // namespace riedel
