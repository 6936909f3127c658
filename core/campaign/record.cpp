#include "core/campaign/record.hpp"

#include "core/base/error.hpp"
#include "core/campaign/read_json.hpp"
#include "core/io/atomic_file.hpp"
#include "core/io/file_name.hpp"
#include "core/io/json_text.hpp"
#include "core/io/version.hpp"

#include <algorithm>
#include <array>
#include <regex>

namespace riedel {

namespace {

namespace fs = std::filesystem;
using nlohmann::ordered_json;

constexpr const char* file_name = "campaign.json";
constexpr std::array own_files{"results.csv",     "report.html",       "curves.png",   "verdicts.md",
                               "campaign.slurm",  "campaign.parallel", "friction.png", "void_ratio.png",
                               "compression.png", "stress_strain.png", "p_q.png",      "shear.png",
                               file_name}; ///< the record last

ordered_json json_of(const PlannedRun& run) {
  ordered_json settings = ordered_json::object();
  for (const auto& [key, value] : run.settings) settings[key] = value;
  return {{"name", run.name},
          {"label", run.label},
          {"legend", run.legend},
          {"settings", settings},
          {"refused", run.refusal},
          {"work", run.work},
          {"final_strain", run.final_strain},
          {"case", run.case_text}};
}

ordered_json json_of(const Plan& plan) {
  ordered_json runs = ordered_json::array();
  for (const PlannedRun& run : plan.runs) runs.push_back(json_of(run));
  return {{"version", version()},
          {"kind", plan.kind->cases.name},
          {"title", plan.title},
          {"command", plan.command},
          {"runs", runs}};
}

/// Checks names that are shown in one line or used as a folder's name, since the file may come from anywhere.
void check_texts(const PlannedRun& run) {
  if (!is_file_name(run.name) || std::ranges::find(own_files, run.name) != own_files.end())
    throw std::runtime_error(ordered_json(run.name).dump() + " is not a valid run name"); // without control characters
  const auto is_control = [](char c) { return static_cast<unsigned char>(c) < 0x20 || c == 0x7f; };
  if (std::ranges::any_of(run.label + run.legend, is_control))
    throw std::runtime_error("a run's label has control characters");
}

PlannedRun run_of(const ordered_json& json) {
  PlannedRun run{.name = json.at("name"),
                 .label = json.at("label"),
                 .settings = {},
                 .case_text = json.at("case"),
                 .refusal = json.at("refused"),
                 .work = json.at("work"),
                 .final_strain = json.at("final_strain"),
                 .legend = json.value("legend", "")};
  for (const auto& [key, value] : json.at("settings").items()) run.settings.emplace_back(key, value);
  check_texts(run);
  return run;
}

const RunKind& kind_named(RunKinds kinds, const std::string& name) {
  const auto found = std::ranges::find(kinds, name, [](const RunKind& kind) { return kind.cases.name; });
  if (found == kinds.end()) throw std::runtime_error(ordered_json(name).dump() + " is not a kind of case");
  return *found;
}

const PlannedRun* run_named(const Plan& plan, const std::string& name) {
  const auto found = std::ranges::find(plan.runs, name, &PlannedRun::name);
  return found == plan.runs.end() ? nullptr : &*found;
}

/// A run that was refused has no case; it may have one now.
bool differ(const PlannedRun& a, const PlannedRun& b) {
  return a.refusal.empty() && b.refusal.empty() && a.case_text != b.case_text;
}

/// Why the plan does not belong to the study in the folder; empty if it does.
std::string difference(const Plan& before, const Plan& plan) {
  if (before.kind->cases.name != plan.kind->cases.name)
    return "its runs are of 'riedel " + before.kind->cases.name + "'";
  bool shared = false;
  for (const PlannedRun& run : plan.runs)
    if (const PlannedRun* old = run_named(before, run.name)) {
      if (differ(*old, run)) return "its run " + run.name + " has a different case";
      shared = true;
    }
  return shared ? "" : "it has no run in common with this one";
}

/// Appends to the plan the runs that only the folder's record has.
Plan united(const fs::path& folder, const Plan& before, const Plan& plan) {
  if (const std::string why = difference(before, plan); !why.empty())
    throw InputError("--out " + folder.string() + ": holds another campaign, '" + before.command + "' with " +
                     std::to_string(before.runs.size()) + " runs: " + why +
                     "; choose another folder, or --force to remove that campaign and its runs");
  Plan all = plan;
  for (const PlannedRun& run : before.runs)
    if (run_named(plan, run.name) == nullptr) all.runs.push_back(run);
  return all;
}

/// Removes only what a campaign wrote: its runs and its own files, the record last, so that this can be repeated.
void remove_campaign(const fs::path& folder, const std::string& command, RunKinds kinds) {
  const Plan before = read_campaign(folder, kinds);
  for (const PlannedRun& run : before.runs) require_idle(folder / run.name, command);
  for (const PlannedRun& run : before.runs) remove_run(folder / run.name, command);
  static const std::regex numbered("void_ratio_[0-9]+[.]png|figure_[0-9]+[a-z]?(_[0-9]+)?[.]png");
  for (const fs::directory_entry& entry : fs::directory_iterator(folder))
    if (std::regex_match(entry.path().filename().string(), numbered)) remove_file(entry.path());
  for (const char* own : own_files) remove_file(folder / own);
}

} // namespace

OpenCampaign open_campaign(const fs::path& folder, const Plan& plan, bool force, RunKinds kinds) {
  OpenCampaign open{.folder = OutputFolder(folder, plan.command, true), .plan = plan};
  const bool is_campaign = fs::symlink_status(folder / file_name).type() != fs::file_type::not_found;
  if (is_campaign && force) remove_campaign(folder, plan.command, kinds);
  if (is_campaign && !force) open.plan = united(folder, read_campaign(folder, kinds), plan);
  if (!is_campaign && !force) open.folder.refuse_results();
  if (force) open.folder.replace();
  write_atomically(folder / file_name, json_text(json_of(open.plan), 1));
  return open;
}

Plan read_campaign(const fs::path& folder, RunKinds kinds) {
  const fs::path path = folder / file_name;
  if (!fs::exists(path)) throw InputError(path.string() + ": cannot be read: the folder holds no campaign");
  try {
    const ordered_json json = read_json(path);
    Plan plan{.kind = &kind_named(kinds, json.value("kind", "biaxial")), // the only kind of earlier versions
              .title = json.at("title"),
              .command = json.at("command"),
              .runs = {}};
    for (const ordered_json& entry : json.at("runs")) {
      PlannedRun run = run_of(entry);
      if (run_named(plan, run.name) != nullptr) throw std::runtime_error("two runs are called " + run.name);
      plan.runs.push_back(std::move(run));
    }
    return plan;
  } catch (const std::exception& error) { throw InputError(path.string() + ": is damaged: " + error.what()); }
}

} // namespace riedel
