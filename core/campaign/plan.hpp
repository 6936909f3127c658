/// What a campaign consists of, before anything runs.
#pragma once

#include "core/campaign/run_kind.hpp"
#include "core/case/plugins.hpp"
#include "core/case/vary.hpp"

namespace riedel {

/// One run, checked.
struct PlannedRun {
  std::string name;  ///< of its folder
  std::string label; ///< for a legend
  std::vector<Setting> settings;
  std::string case_text;     ///< every key in force; empty when refused
  std::string refusal;       ///< why it cannot begin; empty when it can
  double work = 0.0;         ///< expected, in points times steps times what each takes beside the others [-]
  double final_strain = 0.0; ///< at which it ends; 0: not known [-]
  double memory = 0.0;       ///< needed beside the program itself [bytes]; 0: not known
  std::string legend{};      ///< in a plot; empty: the label

  /// The case as a file. Nothing given when the run is refused.
  [[nodiscard]] CaseFile given() const {
    return refusal.empty() ? CaseFile::from_text(case_text, name + "/case.toml") : CaseFile::empty();
  }
};

struct Plan {
  const RunKind* kind; ///< of all runs
  std::string title;
  std::string command; ///< what was typed
  std::vector<PlannedRun> runs;
  std::vector<std::string> warnings = {}; ///< of the checks, each told once

  [[nodiscard]] double work() const; ///< of all runs that can begin
};

/// What a case can name, with the plug-ins that it names itself. @throws PluginError
using CatalogueFor = std::function<Catalogue(const CaseFile& given)>;

/// Checks every variant as its own command would. One that is wrong becomes a run that is refused.
/// @throws InputError for a varied key that no variant has, when two runs share a name, and when not one run can begin
Plan plan_of(const RunKind& kind, std::string title, std::string command, const std::vector<Variant>& variants,
             const CatalogueFor& catalogue_for);

/// Numbers of the runs that can begin, those with the most work first.
std::vector<std::size_t> longest_first(const Plan& plan);

} // namespace riedel
