/// What a campaign consists of, before anything runs.
#pragma once

#include "apps/vary.hpp"

namespace riedel {

/// One run of the biaxial test, checked.
struct PlannedRun {
  std::string name;  ///< of its folder
  std::string label; ///< for a legend
  std::vector<Setting> settings;
  std::string case_text;     ///< every key in force; empty when refused
  std::string refusal;       ///< why it cannot begin; empty when it can
  double work = 0.0;         ///< expected, in points times steps times what each takes beside the others [-]
  double final_strain = 0.0; ///< u/h0 at which it ends [-]
  double memory = 0.0;       ///< needed beside the program itself [bytes]; 0: not known
};

struct Plan {
  std::string title;
  std::string command; ///< what was typed
  std::vector<PlannedRun> runs;
  std::vector<std::string> warnings = {}; ///< of the checks, each told once

  [[nodiscard]] double work() const; ///< of all runs that can begin
};

/// Checks every variant as `riedel biaxial` would. One that is wrong becomes a run that is refused.
/// @throws InputError for a varied key that no variant has, when two runs share a name, and when not one run can begin
Plan plan_of(std::string title, std::string command, const std::vector<Variant>& variants);

/// Numbers of the runs that can begin, those with the most work first.
std::vector<std::size_t> longest_first(const Plan& plan);

} // namespace riedel
