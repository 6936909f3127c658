/// The biaxial test as a kind of case.
#include "apps/biaxial/keys.hpp"
#include "apps/biaxial/memory_needed.hpp"
#include "apps/biaxial/outlook.hpp"
#include "apps/biaxial/sense.hpp"
#include "apps/biaxial/views.hpp"
#include "apps/built_in.hpp"
#include "apps/kinds.hpp"
#include "core/case/case_help.hpp"
#include "core/case/schema.hpp"
#include "core/io/json_text.hpp"

namespace riedel {

namespace {

bool holds(const CaseFile&) { return true; } // takes whatever no other kind takes

std::vector<std::string> words(const CaseFile&) { return {"biaxial"}; }

Keys keys(const CaseFile& given, const Catalogue& catalogue) { return biaxial_keys(catalogue, model_of(given)); }

ExpectedRun expect(const Values& values, const Catalogue& catalogue) {
  const BiaxialCase given(values);
  return {.work = expected_work_of(given, catalogue).work,
          .end = given.loading.final_strain,
          .memory = memory_needed(given, catalogue).of_case()};
}

std::vector<Finding> doubts(const Values& values, const Catalogue& catalogue) {
  const BiaxialCase given(values);
  return time_step_doubts(given, expected_work_of(given, catalogue));
}

std::string outlook(const Values& values, const Catalogue& catalogue, ThreadRange threads) {
  return biaxial_outlook(BiaxialCase(values), catalogue, threads);
}

std::string help(const CaseFile& given, const Catalogue& catalogue) {
  return case_help(given, keys(given, catalogue), catalogue);
}

std::string schema(const CaseFile&, const Catalogue& catalogue) {
  return json_text(case_schema("A biaxial case of Riedel", biaxial_keys(catalogue, paper_model), catalogue));
}

CurveAxes axes(const CaseFile&) {
  return {.x = "u_over_h", .x_label = "u/h₀ [%]", .y = "phi_mob_deg", .y_label = "mobilised friction angle φ [°]"};
}

std::vector<std::pair<std::string, PageTable>> tables(Runs runs) {
  return {{"Shear band", band_table(runs)}, {"Energies and cost", cost_table(runs)}};
}

} // namespace

RunKind biaxial_kind() {
  return {.cases = {.name = "biaxial",
                    .holds = holds,
                    .words = words,
                    .keys = keys,
                    .check = biaxial_case,
                    .expect = expect,
                    .doubts = doubts,
                    .outlook = outlook,
                    .help = help,
                    .schema = schema},
          .curve_file = "history.csv",
          .columns = {"step", "time_s", "u_over_h", "phi_mob_deg"},
          .ascending = {"time_s", "u_over_h"},
          .schemes = full_catalogue().in_2d.schemes.names(),
          .has_frames = true,
          .curves_caption = "Mobilised friction angle over vertical strain.",
          .check_summary = check_biaxial_summary,
          .axes = axes,
          .outcome = biaxial_outcome,
          .tables = tables};
}

} // namespace riedel
