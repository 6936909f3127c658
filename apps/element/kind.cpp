/// An element test as a kind of case.
#include "apps/built_in.hpp"
#include "apps/element/keys.hpp"
#include "apps/element/outlook.hpp"
#include "apps/element/path_keys.hpp"
#include "apps/element/tests/tests.hpp"
#include "apps/element/views.hpp"
#include "apps/kinds.hpp"
#include "core/base/error.hpp"
#include "core/base/suggestion.hpp"
#include "core/case/case_help.hpp"
#include "core/case/key_tables.hpp"
#include "core/case/schema.hpp"
#include "core/io/json_text.hpp"

#include <algorithm>
#include <nlohmann/json.hpp>

namespace riedel {

namespace {

bool holds(const CaseFile& given) { return test_of(given).has_value(); }

std::string test_or_usual(const CaseFile& given) { return test_of(given).value_or(usual_element_test); }

std::vector<std::string> words(const CaseFile& given) { return {"element", test_or_usual(given)}; }

bool is_known(const std::string& test) { return std::ranges::find(element_tests(), test) != element_tests().end(); }

Keys keys(const CaseFile& given, const Catalogue& catalogue) {
  const std::string test = test_or_usual(given);
  Keys all = element_keys(catalogue, is_known(test) ? test : usual_element_test, model_of(given));
  if (test == "path") append(all, path_keys(given));
  return all;
}

std::string help(const CaseFile& given, const Catalogue& catalogue) {
  const std::string test = test_or_usual(given);
  if (!is_known(test))
    throw InputError(given.place("test") + ": \"" + test + "\" is unknown" + did_you_mean(test, element_tests()));
  std::string text = case_help(given, element_keys(catalogue, test, model_of(given)), catalogue);
  if (test == "path")
    text += "\nOf each [[stage]]; docs/howto/element_paths.md explains how they work together\n" +
            parameters_help(stage_keys("")) + "\nOf each [[stage.leg]]\n" + parameters_help(leg_keys(""));
  return text;
}

/// A list of stages, each with a list of legs.
nlohmann::ordered_json stages_schema() {
  const auto with_waves = [](Keys all) {
    append(all, wave_keys(""));
    return object_schema(all);
  };
  nlohmann::ordered_json stage = with_waves(stage_keys(""));
  stage["properties"]["leg"] = {{"type", "array"}, {"items", with_waves(leg_keys(""))}};
  return {{"type", "array"}, {"items", stage}};
}

std::string schema(const CaseFile& given, const Catalogue& catalogue) {
  const std::string test = test_or_usual(given);
  if (!is_known(test)) throw InputError("test = \"" + test + "\" is not known" + did_you_mean(test, element_tests()));
  nlohmann::ordered_json all =
      case_schema("An element test of Riedel: " + test, element_keys(catalogue, test, paper_model), catalogue);
  if (test == "path") all["properties"]["stage"] = stages_schema();
  return json_text(all);
}

CurveAxes axes(const CaseFile& given) {
  const bool shear = shears(test_or_usual(given));
  return {.x = shear ? "gamma" : "eps_1",
          .x_label = shear ? "shear strain γ [%]" : "strain ε₁ [%]",
          .y = "phi_mob_deg",
          .y_label = "mobilised friction angle φ [°]"};
}

std::vector<Finding> doubts(const Values&, const Catalogue&) { return {}; }

} // namespace

RunKind element_kind() {
  return {.cases = {.name = "element",
                    .holds = holds,
                    .words = words,
                    .keys = keys,
                    .check = element_case,
                    .expect = expected_element,
                    .doubts = doubts,
                    .outlook = element_outlook,
                    .help = help,
                    .schema = schema},
          .curve_file = "element.csv",
          .columns = {"eps_1", "eps_2", "eps_3", "gamma", "sigma_1_Pa", "sigma_2_Pa", "sigma_3_Pa", "tau_Pa",
                      "void_ratio", "phi_mob_deg", "time_s"},
          .ascending = {"time_s"},
          .schemes = full_catalogue().in_2d.schemes.names(),
          .curves_caption = "Mobilised friction angle over strain.",
          .check_summary = check_element_summary,
          .axes = axes,
          .outcome = element_outcome,
          .plots = element_run_plots,
          .tables = [](Runs runs) {
            return std::vector{std::pair{std::string("Results"), element_table(runs)}};
          }};
}

} // namespace riedel
