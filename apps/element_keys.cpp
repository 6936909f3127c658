#include "apps/element_keys.hpp"

#include "apps/element_drivers.hpp"
#include "apps/path_keys.hpp"

#include <algorithm>

namespace riedel {

namespace {

const Bounds any{};

Key pressure_key(const std::string& name, double standard, std::string doc) {
  return {"loading." + name, standard, "Pa", more_than(0), std::move(doc)};
}
Key strain_key(double standard, std::string doc, double most = 1.0) {
  return {"loading.final_strain", standard, "-", within(0, most), std::move(doc)};
}

Keys start_keys(const std::string& test) {
  const std::string u = "vertical strain u/h0 at which the test ends";
  if (test == "oedometer")
    return {pressure_key("initial_pressure", 1e3, "pressure from all sides at the start"), strain_key(0.06, u),
            pressure_key("final_stress", 3e6, "vertical stress at which the test ends, if it comes first")};
  if (test == "shear")
    return {pressure_key("normal_stress", 200e3, "normal stress, constant, and pressure from all sides at the start"),
            strain_key(0.5, "shear strain u/h0 at which the test ends", 100.0)};
  if (test == "biaxial")
    return {pressure_key("confining_pressure", 50e3, "lateral pressure, constant"), strain_key(0.06, u)};
  return {pressure_key("confining_pressure", 500e3, "lateral pressure, constant"), strain_key(0.3, u)};
}

Keys problem_keys(const std::string& test) {
  Keys keys{{"test", test, "", any, "what is done to the element", element_tests()},
            {"specimen.void_ratio", test == "biaxial" ? 0.55 : 0.60, "-", more_than(0), "initial void ratio e0"}};
  if (test == "path") {
    append(keys, {{"initial.sigma", std::vector{100e3, 100e3, 100e3}, "Pa", at_least(0),
                   "stresses along 1, 2, 3 at the start, compression positive"},
                  {"initial.tau", 0.0, "Pa", any, "shear stress at the start"}});
    return keys;
  }
  append(keys, start_keys(test));
  keys.push_back({"loading.rate", 0.01, "1/s", more_than(0), "rate of u/h0; of no effect where the law knows no rate"});
  return keys;
}

Keys method_keys() {
  return {{"driver.kind", "point", "", any, "what carries the test out", element_driver_names()},
          {"driver.tolerance", 1e-6, "-", within(0, 0.1),
           "point: error allowed in a step, relative to the stress and to the strain of the step"},
          {"output.every_strain", 5e-4, "-", within(0, 1),
           "strain between rows of element.csv at most; rows are closer where the stress turns"},
          {"output.plots", true, "", any, "write pictures (PNG)"}};
}

void refine_law(Keys& keys) {
  const auto found = std::ranges::find(keys, "material.tolerance", &Key::name);
  if (found != keys.end()) found->default_value = element_law_tolerance;
}

StartPressure start_pressure(const Values& v) {
  if (v.text("test") == "path") {
    const auto& sigma = v.numbers("initial.sigma");
    return {(sigma[0] + sigma[1] + sigma[2]) / 3.0, "initial.sigma", "initial stress"};
  }
  for (const auto& [key, name] :
       {std::pair{"loading.initial_pressure", "initial pressure"}, {"loading.normal_stress", "normal stress"}})
    if (v.has(key)) return {v.number(key), key, name};
  return {v.number("loading.confining_pressure"), "loading.confining_pressure", "confining pressure"};
}

Findings check_element(const Values& v) {
  Findings found;
  check_limits_of_void_ratio(v, found.errors);
  const StartPressure start = start_pressure(v);
  const double least = v.has("material.minimum_pressure") ? v.number("material.minimum_pressure") : -1.0;
  if (start.p + cohesion_pressure(v) <= least)
    found.errors.push_back({{start.key, "material.minimum_pressure"},
                            "the mean pressure at the start, " + rounded(start.p) + " Pa, must exceed " +
                                rounded(least - cohesion_pressure(v)) +
                                " Pa (material.minimum_pressure): below it the grains are apart"});
  else
    check_void_ratio(v, "specimen.void_ratio", start, found.errors);
  if (v.text("test") == "path") check_path(v, found.errors);
  return found;
}

} // namespace

const std::vector<std::string>& element_tests() {
  static const std::vector<std::string> all{"oedometer", "triaxial", "shear", "biaxial", "path"};
  return all;
}

Keys element_keys(const Catalogue& catalogue, const std::string& test, std::string_view model) {
  Keys keys = problem_keys(test);
  append_material(keys, catalogue, model);
  refine_law(keys);
  append(keys, method_keys());
  return keys;
}

std::optional<std::string> test_of(const CaseFile& given) { return given.peek_text("test"); }

CheckedCase element_case(const CaseFile& given, const Catalogue& catalogue) {
  const std::string wish = test_of(given).value_or("triaxial");
  const bool known = std::ranges::find(element_tests(), wish) != element_tests().end();
  Keys keys = element_keys(catalogue, known ? wish : "triaxial", model_of(given));
  if (wish == "path") append(keys, path_keys(given));
  CheckedCase checked = checked_case(given, std::move(keys), check_element);
  // A measure that a stage leaves free is no condition: nothing to write down.
  std::erase_if(checked.keys, [&](const Key& key) {
    return key.name.starts_with("stage.") && checked.values.at(key.name) == Value(std::string(free_word));
  });
  return checked;
}

} // namespace riedel
