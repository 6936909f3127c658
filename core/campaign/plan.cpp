#include "core/campaign/plan.hpp"

#include "core/base/error.hpp"
#include "core/base/suggestion.hpp"
#include "core/campaign/legend.hpp"
#include "core/case/case_text.hpp"

#include <algorithm>
#include <numeric>
#include <set>

namespace riedel {

namespace {

std::string joined(const std::vector<std::string>& words) {
  std::string all;
  for (const std::string& word : words) all += (all.empty() ? "" : " ") + word;
  return all;
}

/// The names of all keys of any variant: each law adds its own.
std::set<std::string> known_keys(const RunKind& kind, const std::vector<Variant>& variants,
                                 const CatalogueFor& catalogue_for) {
  std::set<std::string> names;
  for (const Variant& variant : variants) {
    try {
      for (const Key& key : kind.cases.keys(variant.given, catalogue_for(variant.given))) names.insert(key.name);
    } catch (const PluginError&) {} // the run's row will show it
  }
  return names;
}

void refuse_unknown_keys(const RunKind& kind, const std::vector<Variant>& variants, const CatalogueFor& catalogue_for) {
  const std::set<std::string> known = known_keys(kind, variants, catalogue_for);
  for (const Setting& setting : variants.front().settings)
    if (!known.contains(setting.first))
      throw InputError("--vary " + setting.first + ": unknown key" +
                       did_you_mean(setting.first, std::vector<std::string>(known.begin(), known.end())) +
                       "; 'riedel " + joined(kind.cases.words(variants.front().given)) +
                       " --help' lists the known ones");
}

void refuse_shared_names(const std::vector<PlannedRun>& runs) {
  std::set<std::string> names;
  std::vector<NamedCase> cases;
  for (const PlannedRun& run : runs) {
    if (!names.insert(run.name).second) throw InputError("two runs would share the folder " + run.name);
    if (run.refusal.empty()) cases.push_back({run.name, run.case_text});
  }
  refuse_same_cases(cases);
}

PlannedRun planned(const RunKind& kind, const Variant& variant, const CatalogueFor& catalogue_for,
                   std::vector<std::string>& warnings) {
  PlannedRun run{
      .name = variant.name, .label = variant.label, .settings = variant.settings, .case_text = "", .refusal = ""};
  try {
    const Catalogue catalogue = catalogue_for(variant.given);
    const CheckedCase checked = kind.cases.check(variant.given, catalogue);
    for (const std::string& warning : checked.warnings)
      if (std::ranges::find(warnings, warning) == warnings.end()) warnings.push_back(warning);
    run.case_text = case_text(checked.keys, checked.values);
    const ExpectedRun expected = kind.cases.expect(checked.values, catalogue);
    run.work = expected.work;
    run.final_strain = expected.end;
    run.memory = expected.memory;
    run.legend = legend_label(run.settings, checked.keys);
  } catch (const InputError& error) { run.refusal = error.what(); } catch (const PluginError& error) {
    run.refusal = error.what();
  }
  return run;
}

} // namespace

double Plan::work() const {
  return std::accumulate(runs.begin(), runs.end(), 0.0,
                         [](double sum, const PlannedRun& run) { return sum + run.work; });
}

Plan plan_of(const RunKind& kind, std::string title, std::string command, const std::vector<Variant>& variants,
             const CatalogueFor& catalogue_for) {
  refuse_unknown_keys(kind, variants, catalogue_for);
  Plan plan{.kind = &kind, .title = std::move(title), .command = std::move(command), .runs = {}};
  for (const Variant& variant : variants) plan.runs.push_back(planned(kind, variant, catalogue_for, plan.warnings));
  refuse_shared_names(plan.runs);
  if (std::ranges::none_of(plan.runs, [](const PlannedRun& run) { return run.refusal.empty(); }))
    throw InputError("none of the runs can start; the first, " + plan.runs.front().name + ": " +
                     plan.runs.front().refusal);
  return plan;
}

std::vector<std::size_t> longest_first(const Plan& plan) {
  std::vector<std::size_t> order;
  for (std::size_t i = 0; i < plan.runs.size(); ++i)
    if (plan.runs[i].refusal.empty()) order.push_back(i);
  std::ranges::stable_sort(order, std::ranges::greater(), [&](std::size_t i) { return plan.runs[i].work; });
  return order;
}

} // namespace riedel
