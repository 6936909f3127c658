#include "apps/campaign/record.hpp"

#include "apps/command_line.hpp"
#include "apps/output_folder.hpp"
#include "core/base/error.hpp"
#include "core/io/atomic_file.hpp"

#include <algorithm>
#include <fstream>
#include <nlohmann/json.hpp>

namespace riedel {

namespace {

namespace fs = std::filesystem;
using nlohmann::ordered_json;

constexpr const char* file_name = "campaign.json";

ordered_json json_of(const PlannedRun& run) {
  ordered_json settings = ordered_json::object();
  for (const auto& [key, value] : run.settings) settings[key] = value;
  return {{"name", run.name},       {"label", run.label}, {"settings", settings},
          {"refused", run.refusal}, {"work", run.work},   {"final_strain", run.final_strain},
          {"case", run.case_text}};
}

ordered_json json_of(const Plan& plan) {
  ordered_json runs = ordered_json::array();
  for (const PlannedRun& run : plan.runs) runs.push_back(json_of(run));
  return {{"version", version()}, {"title", plan.title}, {"command", plan.command}, {"runs", runs}};
}

PlannedRun run_of(const ordered_json& json) {
  PlannedRun run{.name = json.at("name"),
                 .label = json.at("label"),
                 .settings = {},
                 .case_text = json.at("case"),
                 .refusal = json.at("refused"),
                 .work = json.at("work"),
                 .final_strain = json.at("final_strain")};
  for (const auto& [key, value] : json.at("settings").items()) run.settings.emplace_back(key, value);
  if (run.name.empty() || fs::path(run.name).has_parent_path() || run.name == "..")
    throw std::runtime_error("'" + run.name + "' is no name of a run");
  return run;
}

/// Same runs with the same cases in the same order; the words of the command may differ.
bool same_runs(const Plan& a, const Plan& b) {
  return std::ranges::equal(a.runs, b.runs, [](const PlannedRun& x, const PlannedRun& y) {
    return x.name == y.name && x.settings == y.settings && x.case_text == y.case_text;
  });
}

/// Only what a campaign wrote: its runs' folders and its own files.
void remove_campaign(const fs::path& folder) {
  for (const PlannedRun& run : read_campaign(folder).runs) fs::remove_all(folder / run.name);
  for (const char* result : {"results.csv", "report.html", "curves.png", file_name}) fs::remove(folder / result);
  for (int number = 1; fs::remove(folder / ("void_ratio_" + std::to_string(number) + ".png")); ++number) {}
}

} // namespace

void open_campaign(const fs::path& folder, const Plan& plan, bool force) {
  if (fs::exists(folder / file_name)) {
    if (force) {
      remove_campaign(folder);
    } else {
      const Plan before = read_campaign(folder);
      if (same_runs(before, plan)) return;
      throw InputError("--out " + folder.string() + ": holds another campaign, '" + before.command + "' with " +
                       std::to_string(before.runs.size()) +
                       " runs; choose another folder, or --force to remove that campaign and its runs");
    }
  }
  prepare_output_folder(folder, force);
  write_atomically(folder / file_name, json_of(plan).dump(1) + "\n");
}

Plan read_campaign(const fs::path& folder) {
  const fs::path path = folder / file_name;
  std::ifstream file(path);
  if (!file) throw InputError(path.string() + ": cannot be read: the folder holds no campaign");
  try {
    const ordered_json json = ordered_json::parse(file);
    Plan plan{.title = json.at("title"), .command = json.at("command"), .runs = {}};
    for (const ordered_json& run : json.at("runs")) plan.runs.push_back(run_of(run));
    return plan;
  } catch (const std::exception& error) { throw InputError(path.string() + ": is damaged: " + error.what()); }
}

} // namespace riedel
