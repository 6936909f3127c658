#include "apps/campaign/run_result.hpp"

#include "apps/command_line.hpp"
#include "core/base/error.hpp"
#include "core/io/atomic_file.hpp"

#include <algorithm>
#include <fstream>
#include <sstream>

namespace riedel {

namespace {

namespace fs = std::filesystem;
using nlohmann::ordered_json;

std::string content_of(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

std::string first_line(const std::string& text) { return text.substr(0, text.find('\n')); }

/// Status, reason and history of a run that has left a summary.
void read_results(RunResult& result) {
  const std::string status = result.summary.at("status");
  const fs::path history = result.folder / "history.csv";
  if (status == "failed") {
    result.status = RunStatus::failed;
    result.reason = first_line(result.summary.at("reason"));
    try {
      result.history = read_table(history);
    } catch (const InputError&) {} // it may have failed before a row was written, or in the middle of one
    return;
  }
  if (status == "done") {
    result.status = RunStatus::done;
    (void)result.summary.at("band").at("found");
  } else {
    result.reason = status + " before its end";
  }
  result.history = read_table(history);
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

RunResult result_of(const PlannedRun& run, const fs::path& campaign) {
  RunResult result{.name = run.name, .label = run.label, .settings = run.settings, .folder = campaign / run.name};
  if (!run.refusal.empty()) {
    result.status = RunStatus::refused;
    result.reason = first_line(run.refusal);
    return result;
  }
  const fs::path summary = result.folder / "summary.json", given = result.folder / "case.toml";
  result.reason = "not run, or stopped before its end";
  if (!fs::exists(summary)) return result;
  if (content_of(given) != run.case_text) {
    mark_damaged(result, given.string() + ": is not the case of this campaign");
    return result;
  }
  result.reason.clear();
  try {
    result.summary = ordered_json::parse(content_of(summary));
    read_results(result);
  } catch (const ordered_json::exception& error) {
    mark_damaged(result, summary.string() + ": cannot be understood: " + error.what());
  } catch (const InputError& error) { mark_damaged(result, error.what()); }
  return result;
}

std::vector<RunResult> results_of(const Plan& plan, const fs::path& campaign) {
  std::vector<RunResult> results;
  for (const PlannedRun& run : plan.runs) results.push_back(result_of(run, campaign));
  return results;
}

void write_failed_summary(const fs::path& folder, const std::string& reason) {
  const ordered_json summary{{"case", "biaxial"}, {"version", version()}, {"status", "failed"}, {"reason", reason}};
  write_atomically(folder / "summary.json", summary.dump(2) + "\n");
}

} // namespace riedel
