/// A run of a campaign as its folder tells it.
#pragma once

#include "core/campaign/plan.hpp"
#include "core/io/table.hpp"

#include <nlohmann/json.hpp>

namespace riedel {

/// `refused`: wrong before it began; `missing`: not begun, or not come to its end; `damaged`: its files cannot be read.
enum class RunStatus { done, failed, refused, missing, damaged };
[[nodiscard]] const char* name_of(RunStatus status);

struct RunResult {
  std::string name;              ///< of its folder inside the campaign's
  std::string label;             ///< for a table
  std::string legend{};          ///< for a plot
  std::vector<Setting> settings; ///< what it differs in from others: key, value as TOML
  std::filesystem::path folder;
  RunStatus status = RunStatus::missing;
  std::string reason{};             ///< why it is not done, in one line
  nlohmann::ordered_json summary{}; ///< summary.json; null where there is none
  Table history{};                  ///< its curve, such as history.csv; without columns where there is none
  CurveAxes axes{};
};

/// Every run of the plan, in its order; nothing is thrown for what is missing or cannot be read.
std::vector<RunResult> results_of(const Plan& plan, const std::filesystem::path& campaign);
RunResult result_of(const RunKind& kind, const PlannedRun& run, const std::filesystem::path& campaign);

/// A run that ended without leaving a summary gets one that says why. @throws RunError
void write_failed_summary(const RunKind& kind, const std::filesystem::path& folder, const std::string& reason);

} // namespace riedel
