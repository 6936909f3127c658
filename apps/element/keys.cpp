#include "apps/element/keys.hpp"

#include "apps/case_kind.hpp"
#include "apps/element/drivers.hpp"
#include "apps/element/path_check.hpp"
#include "apps/element/path_keys.hpp"
#include "apps/element/specimen.hpp"
#include "apps/element/tests/tests.hpp"
#include "core/case/dimension_check.hpp"
#include "core/case/interpolation_keys.hpp"
#include "core/case/step_keys.hpp"
#include "core/case/transfer_keys.hpp"
#include "core/io/with_vtk.hpp"

#include <algorithm>
#include <cmath>

namespace riedel {

namespace {

const Bounds any{};

std::string names_of_tests(bool (*holds)(const ElementTest&)) {
  std::string names;
  for (const ElementTest& test : named_element_tests())
    if (holds(test)) names += (names.empty() ? "" : ", ") + test.name;
  return names;
}

Keys problem_keys(const std::string& test) {
  const ElementTest* const named = find_element_test(test);
  Keys keys{
      {"test", test, "", any, "the element test", element_tests()},
      {"specimen.void_ratio", named == nullptr ? 0.60 : named->void_ratio, "-", more_than(0), "initial void ratio e0"}};
  if (named == nullptr) {
    append(keys,
           {{"specimen.water_bulk_modulus", 0.0, "Pa", at_least(0),
             "of pore water that cannot drain, such as 2.2 GPa; 0: no water"},
            {"initial.sigma", std::vector{100e3, 100e3, 100e3}, "Pa", at_least(0),
             "stresses along 1, 2, 3 at the start, compression positive"},
            {"initial.tau", 0.0, "Pa", any, "shear stress 12 at the start"},
            {"initial.tau_13", 0.0, "Pa", any, "shear stress 13 at the start"},
            {"initial.tau_23", 0.0, "Pa", any, "shear stress 23 at the start"},
            {"initial.pore_pressure", 0.0, "Pa", any, "pressure of the pore water at the start, part of initial.sigma"},
            {"initial.intergranular_strain", std::vector{0.0, 0.0, 0.0}, "-", any,
             "intergranular strain along 1, 2, 3 at the start, compression positive"}});
    return keys;
  }
  append(keys, named->loading);
  keys.push_back(
      {"loading.rate", 0.01, "1/s", more_than(0), "rate of u/h0; without effect for a rate-independent law"});
  return keys;
}

Keys point_keys() {
  return {{"driver.kind", "point", "", any, "what runs the test", element_driver_names()},
          {"driver.tolerance", 1e-6, "-", between(1e-12, 0.1),
           "point: error allowed in a step, relative to the stress and to the strain of the step"}};
}

/// Keys of the specimen that the mpm driver runs.
Keys mpm_keys(const Catalogue& catalogue) {
  Keys keys{
      {"scheme", "gimp", "", any, "interpolation between points and grid", catalogue.in_2d.schemes.names()},
      {"specimen.size", 0.01, "m", more_than(0), "edge of the specimen, a square or a cube"},
      {"specimen.points_per_cell", std::int64_t{2}, "-", between(1, 10),
       "material points per cell and direction; with one, the stretching of a cell has no inertia"},
      {"specimen.interior",
       "affine",
       "",
       any,
       "nodes between the plates: move in proportion, so that the specimen stays homogeneous, or are free; in the "
       "shear test always affine",
       {"affine", "free"}},
      {"grid.cells", std::int64_t{1}, "-", between(1, 1000), "cells along each edge of the specimen"},
      {"grid.dimensions",
       "auto",
       "-",
       between(2, 3),
       "2: plane strain; auto: 3 for the " +
           names_of_tests([](const ElementTest& test) { return test.dimensions == 3; }) + " test, 2 for the others",
       {"auto"}},
      {"loading.speed", 0.01, "m/s", more_than(0), "speed of the driven plate"},
      {"loading.ramp_time", 5e-3, "s", at_least(0), "time over which the speed rises smoothly from zero"}};
  append(keys, interpolation_keys(catalogue));
  append(keys, step_keys(catalogue, element_step_defaults));
  for (Key& key : keys) key.doc = "mpm: " + key.doc;
  return keys;
}

Keys output_keys() {
  return {{"output.every_strain", 5e-4, "-", within(0, 1),
           "maximum strain between rows of element.csv; rows are closer where the stress turns"},
          key_for_vtk("output.plots", "write pictures (PNG)")};
}

void refine_law(Keys& keys) {
  const auto found = std::ranges::find(keys, "material.tolerance", &Key::name);
  if (found != keys.end()) found->default_value = element_law_tolerance;
}

StartPressure start_pressure(const ElementCase& given) {
  if (given.named == nullptr)
    return {-trace(given.initial.total_stress) / 3.0 - given.initial.pore_pressure, "initial.sigma", "initial stress"};
  return {given.loading.pressure, given.named->pressure_key, given.named->pressure_name};
}

/// Initial intergranular strain needs a law that has it, and must lie in its elastic range.
void check_intergranular_strain(const ElementCase& given, std::vector<Finding>& errors) {
  const Values& v = given.keys;
  double squares = 0.0;
  for (const double h : given.initial.intergranular_strain) squares += h * h;
  if (squares == 0.0) return;
  if (!v.has("material.intergranular_strain") || !v.flag("material.intergranular_strain"))
    errors.push_back({{"initial.intergranular_strain"},
                      "the law has no intergranular strain; allowed: 0, or material.intergranular_strain = true"});
  else if (std::sqrt(squares) > v.number("material.R") * (1.0 + 1e-9))
    errors.push_back({{"initial.intergranular_strain", "material.R"},
                      "its norm, " + rounded(std::sqrt(squares)) +
                          ", is out of range; allowed: at most R = " + rounded(v.number("material.R"))});
}

/// A larger specimen would fill the memory before its first step.
void check_points(const ElementCase::Specimen& specimen, std::vector<Finding>& errors) {
  constexpr double maximum = 1e7;
  const double points = std::pow(static_cast<double>(specimen.cells * specimen.points_per_cell), specimen.dimensions);
  if (points > maximum)
    errors.push_back({{"grid.cells", "specimen.points_per_cell"},
                      exact_text(static_cast<double>(specimen.cells)) + " along each edge make " + rounded(points) +
                          " points; allowed: at most " + rounded(maximum)});
}

/// What the mpm driver cannot do.
void check_specimen(const ElementCase& given, std::vector<Finding>& errors) {
  if (given.named == nullptr) {
    errors.push_back(
        {{"driver.kind"},
         "\"mpm\" cannot run a path: its specimen is between plates; allowed: \"point\", or one of the tests " +
             names_of_tests([](const ElementTest&) { return true; })});
    return;
  }
  check_points(given.specimen, errors);
  if (given.keys.is_text("grid.dimensions")) return;
  const double dimensions = given.keys.number("grid.dimensions"); // it may have a fraction
  if (dimensions != 2.0 && dimensions != 3.0)
    errors.push_back({{"grid.dimensions"}, exact_text(dimensions) + " is no number of dimensions; allowed: 2, 3"});
  else if (dimensions < given.named->dimensions)
    errors.push_back(
        {{"grid.dimensions"}, "2 is plane strain, and a " + given.test + " test is not; allowed: 3, \"auto\""});
}

Diagnostics check_element(const ElementCase& given, const Catalogue& catalogue) {
  const Values& v = given.keys;
  Diagnostics found;
  check_limits_of_void_ratio(v, found.errors);
  const StartPressure start = start_pressure(given);
  const double minimum = v.has("material.minimum_pressure") ? v.number("material.minimum_pressure") : -1.0;
  if (start.p + cohesion_pressure(v) <= minimum)
    found.errors.push_back({{start.key, "material.minimum_pressure"},
                            "the mean pressure at the start, " + rounded(start.p) + " Pa, must exceed " +
                                rounded(minimum - cohesion_pressure(v)) +
                                " Pa (material.minimum_pressure): below it the grains are apart"});
  else
    check_void_ratio(v, "specimen.void_ratio", start, found.errors);
  if (given.named == nullptr) {
    check_path(given, found.errors);
    check_intergranular_strain(given, found.errors);
  } else {
    check_rows(given.every_strain, element_path(given), found.errors);
  }
  if (given.driver.kind != "mpm") return found;
  check_specimen(given, found.errors);
  if (given.named != nullptr) {
    check_step(v, catalogue, found.errors);
    check_interpolation(v, catalogue, found.errors);
    check_offered(v, catalogue, given.specimen.dimensions, found.errors);
    check_transfer(v, catalogue, found);
  }
  return found;
}

} // namespace

const std::vector<std::string>& element_tests() {
  static const std::vector<std::string> all = [] {
    std::vector<std::string> names;
    for (const ElementTest& test : named_element_tests()) names.push_back(test.name);
    names.emplace_back("path");
    return names;
  }();
  return all;
}

Keys element_keys(const Catalogue& catalogue, const std::string& test, std::string_view model) {
  Keys keys = problem_keys(test);
  append_material(keys, catalogue, model, paper_model);
  refine_law(keys);
  append(keys, point_keys());
  if (test != "path") append(keys, mpm_keys(catalogue));
  append(keys, output_keys());
  return keys;
}

std::optional<std::string> test_of(const CaseFile& given) { return given.peek_text("test"); }

CheckedCase element_case(const CaseFile& given, const Catalogue& catalogue) {
  const std::string wish = test_of(given).value_or(usual_element_test);
  const bool known = std::ranges::find(element_tests(), wish) != element_tests().end();
  Keys keys = element_keys(catalogue, known ? wish : usual_element_test, model_of(given));
  if (wish == "path") append(keys, path_keys(given));
  CheckedCase checked = checked_case(
      given, std::move(keys), [&](const Values& values) { return check_element(ElementCase(values), catalogue); },
      [&](std::vector<Finding>& errors) {
        explain_unknown_element_keys(given, known ? wish : usual_element_test, catalogue, errors);
      });
  try_material(given, checked.values, catalogue);
  // Measures that a stage leaves free and sines without amplitude are no conditions: they are not written.
  std::erase_if(checked.keys, [&](const Key& key) {
    if (!key.name.starts_with("stage.")) return false;
    const bool wave = key.name.ends_with(swing_key("")) || key.name.ends_with(phase_key(""));
    if (key.name.ends_with("deformation_gradient")) return checked.values.numbers(key.name).empty();
    return checked.values.at(key.name) == (wave ? Value(0.0) : Value(std::string(free_word)));
  });
  return checked;
}

} // namespace riedel
