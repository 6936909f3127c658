/// What a campaign consists of, before any run starts.
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
  std::string refusal;       ///< why it cannot start; empty if it can
  double work = 0.0;         ///< expected: points times steps times relative cost of each [-]
  double final_strain = 0.0; ///< at which it ends; 0: unknown [-]
  double memory = 0.0;       ///< needed in addition to the program itself [bytes]; 0: unknown
  std::string legend{};      ///< in a plot; empty: the label

  /// The case as a file; empty if the run is refused.
  [[nodiscard]] CaseFile given() const {
    return refusal.empty() ? CaseFile::from_text(case_text, name + "/case.toml") : CaseFile::empty();
  }
};

struct Plan {
  const RunKind* kind; ///< of all runs
  std::string title;
  std::string command; ///< as typed
  std::vector<PlannedRun> runs;
  std::vector<std::string> warnings = {}; ///< of the checks, each reported once

  [[nodiscard]] double work() const; ///< of all runs that can start
};

/// Everything that a case can name, including from its own plug-ins. @throws PluginError
using CatalogueFor = std::function<Catalogue(const CaseFile& given)>;

/// Checks every variant as its own command would. An invalid variant becomes a refused run.
/// @throws InputError for a varied key that no variant has, if two runs share a name, and if no run can start
Plan plan_of(const RunKind& kind, std::string title, std::string command, const std::vector<Variant>& variants,
             const CatalogueFor& catalogue_for);

/// Indices of the runs that can start, those with the most work first.
std::vector<std::size_t> longest_first(const Plan& plan);

} // namespace riedel
