/// A run of a campaign as found in its folder.
#pragma once

#include "core/campaign/plan.hpp"
#include "core/io/table.hpp"

#include <nlohmann/json.hpp>

namespace riedel {

/// `refused`: invalid before it started; `missing`: not started, or not finished; `damaged`: its files cannot be read.
enum class RunStatus { done, failed, refused, missing, damaged };
[[nodiscard]] const char* name_of(RunStatus status);

struct RunResult {
  std::string name;              ///< of its folder in the campaign's folder
  std::string label;             ///< for a table
  std::string legend{};          ///< for a plot
  std::vector<Setting> settings; ///< settings in which it differs from others: key, value as TOML
  std::filesystem::path folder;
  RunStatus status = RunStatus::missing;
  std::string reason{};             ///< why it is not finished, in one line
  nlohmann::ordered_json summary{}; ///< summary.json; null if there is none
  Table history{};                  ///< its curve, such as history.csv; without columns if there is none
  CurveAxes axes{};
};

/// All runs of the plan, in its order; nothing is thrown for missing or unreadable files.
std::vector<RunResult> results_of(const Plan& plan, const std::filesystem::path& campaign);
RunResult result_of(const RunKind& kind, const PlannedRun& run, const std::filesystem::path& campaign);

/// Writes a summary with the reason for a run that ended without one. @throws RunError
void write_failed_summary(const RunKind& kind, const std::filesystem::path& folder, const std::string& reason);

} // namespace riedel
