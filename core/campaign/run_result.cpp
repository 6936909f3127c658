#include "core/campaign/run_result.hpp"

#include "core/base/error.hpp"
#include "core/campaign/read_json.hpp"
#include "core/io/atomic_file.hpp"
#include "core/io/input_file.hpp"
#include "core/io/json_text.hpp"
#include "core/io/version.hpp"

#include <algorithm>
#include <cmath>

namespace riedel {

namespace {

namespace fs = std::filesystem;
using nlohmann::ordered_json;

std::string first_line(const std::string& text) { return text.substr(0, text.find('\n')); }

/// Checks what tables and pages rely on in a finished run.
void check_summary(const RunKind& kind, const RunResult& result) {
  try {
    kind.check_summary(result.summary);
  } catch (const InputError& error) {
    throw InputError((result.folder / "summary.json").string() + ": " + error.what());
  }
}

void check_history(const RunKind& kind, const Table& history) {
  for (const std::string& column : kind.columns)
    if (!history.has(column)) throw InputError("has no column " + column);
  for (const std::string& column : kind.ascending) {
    const std::vector<double>& values = history[column];
    if (!std::ranges::all_of(values, [](double x) { return std::isfinite(x); }) || !std::ranges::is_sorted(values))
      throw InputError("column " + column + " does not rise from number to number");
  }
}

/// The complete table, or one without columns.
Table history_of(const RunKind& kind, const RunResult& result) {
  const fs::path file = result.folder / kind.curve_file;
  Table history = read_table(file);
  try {
    check_history(kind, history);
  } catch (const InputError& error) { throw InputError(file.string() + ": " + error.what()); }
  return history;
}

/// Status, reason and history of a run that wrote a summary.
void read_results(const RunKind& kind, RunResult& result) {
  const std::string status = result.summary.at("status");
  if (status == "failed") {
    result.status = RunStatus::failed;
    result.reason = first_line(result.summary.at("reason"));
    try {
      result.history = history_of(kind, result);
    } catch (const InputError&) {} // it may have failed before or while a row was written
    return;
  }
  if (status != "done" && status != "interrupted")
    throw InputError((result.folder / "summary.json").string() + ": '" + status + "' is not the status of a run");
  if (status == "done") {
    result.status = RunStatus::done;
    check_summary(kind, result);
  } else {
    result.reason = status + " before its end";
  }
  result.history = history_of(kind, result);
}

void mark_damaged(RunResult& result, const std::string& why) {
  result.status = RunStatus::damaged;
  result.reason = first_line(why);
  result.summary = nullptr;
  result.history = {};
}

} // namespace

const char* name_of(RunStatus status) {
  constexpr std::array names{"done", "failed", "refused", "missing", "damaged"};
  return names[static_cast<std::size_t>(status)];
}

RunResult result_of(const RunKind& kind, const PlannedRun& run, const fs::path& campaign) {
  RunResult result{.name = run.name,
                   .label = run.label,
                   .legend = run.legend.empty() ? run.label : run.legend,
                   .settings = run.settings,
                   .folder = campaign / run.name};
  if (!run.refusal.empty()) {
    result.status = RunStatus::refused;
    result.reason = first_line(run.refusal);
    return result;
  }
  const fs::path summary = result.folder / "summary.json", given = result.folder / "case.toml";
  result.reason = "not run, or stopped before its end";
  std::error_code unknown;
  if (!fs::exists(summary, unknown)) return result;
  try {
    if (read_input_file(given) != run.case_text)
      throw InputError(given.string() + ": is not the case of this campaign");
    result.axes = kind.axes(run.given());
    result.reason.clear();
    result.summary = read_json(summary);
    if (!result.summary.is_object()) throw InputError(summary.string() + ": cannot be understood: not a JSON object");
    read_results(kind, result);
  } catch (const ordered_json::exception& error) {
    mark_damaged(result, summary.string() + ": cannot be understood: " + error.what());
  } catch (const std::exception& error) { mark_damaged(result, error.what()); }
  return result;
}

std::vector<RunResult> results_of(const Plan& plan, const fs::path& campaign) {
  std::vector<RunResult> results;
  for (const PlannedRun& run : plan.runs) results.push_back(result_of(*plan.kind, run, campaign));
  return results;
}

void write_failed_summary(const RunKind& kind, const fs::path& folder, const std::string& reason) {
  const ordered_json summary{
      {"case", kind.cases.name}, {"version", version()}, {"status", "failed"}, {"reason", reason}};
  write_atomically(folder / "summary.json", json_text(summary));
}

} // namespace riedel
