/// riedel compare: one case under many settings, side by side; riedel collect: the same from runs made elsewhere.
#include "apps/built_in.hpp"
#include "apps/commands.hpp"
#include "apps/compare/study.hpp"
#include "apps/kinds.hpp"
#include "core/base/error.hpp"
#include "core/campaign/record.hpp"
#include "core/campaign/report.hpp"
#include "core/campaign/results_table.hpp"
#include "core/campaign/run_campaign.hpp"
#include "core/campaign/script.hpp"
#include "core/io/atomic_file.hpp"
#include "core/io/messages.hpp"
#include "core/run/failure.hpp"
#include "core/run/interrupt.hpp"

#include <algorithm>
#include <cstdio>
#include <iostream>

namespace riedel {

namespace {

namespace fs = std::filesystem;

fs::path folder_of(const Arguments& arguments) {
  return arguments.out(fs::path("results") /
                       (arguments.words.empty() ? "compare" : fs::path(arguments.words.front()).stem()));
}

void print_runs(const Plan& plan) {
  std::printf("%zu runs; share of the expected work\n", plan.runs.size());
  for (const PlannedRun& run : plan.runs) {
    if (run.refusal.empty())
      std::printf("%5.1f %%  %s\n", 100.0 * run.work / plan.work(), run.name.c_str());
    else
      std::printf("refused  %s: %s\n", run.name.c_str(), run.refusal.c_str());
  }
}

/// Tables and report of the runs in the folder. @return the exit code: 3 if no run completed
int write_results(const Plan& plan, const fs::path& folder) {
  const std::vector<RunResult> results = results_of(plan, folder);
  write_atomically(folder / "results.csv", results_csv(results));
  std::vector<std::string> written{"results.csv"};
  try_to_write("the report", [&] {
    write_atomically(folder / "report.html", campaign_report(plan, results).html());
    written.emplace_back("report.html");
  });
  try_to_write("the pictures", [&] {
    for (std::string& name : write_campaign_pictures(plan, results, folder)) written.push_back(std::move(name));
  });
  std::cout << results_text(*plan.kind, results) << "written to " << folder.string();
  for (const std::string& name : written) std::cout << (&name == &written.front() ? ": " : ", ") << name;
  std::cout << "\n";
  for (const RunResult& result : results)
    if (result.status == RunStatus::damaged) print_warning(result.name + " is damaged: " + result.reason);
  return std::ranges::any_of(results, [](const RunResult& r) { return r.status == RunStatus::done; }) ? 0 : 3;
}

int compare(const Arguments& arguments) {
  const auto kind = arguments.text("script");
  if (kind) (void)arguments.names("script", {}, script_kinds());
  const int threads = arguments.threads().maximum;
  const Study study = study_of(arguments);
  const Plan plan =
      plan_of(kind_of(study.given), study.title, arguments.command, variants_of(study.given, study.variations),
              [](const CaseFile& given) { return load_catalogue(given).catalogue; });
  for (const std::string& warning : plan.warnings) print_warning(warning);
  if (arguments.has("dry-run")) {
    print_runs(plan);
    return 0;
  }
  const fs::path folder = folder_of(arguments);
  const Interrupt interrupt;
  const OpenCampaign campaign = open_campaign(folder, plan, arguments.force(), run_kinds());
  if (kind) {
    const fs::path script = write_script(*kind, plan, folder);
    std::cout << "written to " << script.string() << "; when its runs have ended: riedel collect " << folder.string()
              << "\n";
    return 0;
  }
  run_campaign(plan, folder, {"compare", threads, [&] { return static_cast<bool>(interrupt); }});
  const int code = write_results(campaign.plan, folder);
  return interrupt ? interrupt.exit_code() : code;
}

int collect(const Arguments& arguments) {
  if (arguments.words.empty()) throw InputError("riedel collect needs the folder of a campaign");
  const fs::path folder = arguments.words.front();
  const Plan plan = read_campaign(folder, run_kinds());
  const FolderLock lock(folder, arguments.command); // otherwise a campaign could write older results at its end
  return write_results(plan, folder);
}

Options compare_options() {
  Options options = case_options();
  std::vector<std::string> schemes = full_catalogue().in_2d.schemes.names();
  schemes.emplace_back("all");
  options.push_back({"schemes", "A,B", "interpolation schemes; 'all' stands for all of them", true, schemes});
  options.push_back({"vary", "KEY=A,B", "values of a key; if repeated, all combinations are run", true});
  options.push_back({"out", "DIR", "folder of the campaign; default: results/ and the name of the case file"});
  options.push_back({"threads", "N", "for all runs together; default: all of the machine"});
  options.push_back({"dry-run", "", "list the runs, with their shares of the work, and start none"});
  options.push_back({"script", "KIND", "start none, but write a script to run them elsewhere: slurm or parallel", false,
                     script_kinds()});
  options.push_back({"force", "", "remove the campaign in the folder, with its runs"});
  return options;
}

std::string compare_help(const Arguments&) {
  return R"(Every combination is a run in its own folder, of the biaxial test or of the element test that the key test
names. The row of a run that fails or cannot begin says so. A campaign that was stopped or killed
continues when the same command is given again. results.csv has a row for each run, with every value of its
summary.json; report.html shows curves, fields and tables in a browser.

A case file can state what is varied, and still be run as a single case:

  [compare]
  title = "Mesh and length"
  schemes = ["gimp", "cpdi"]
  vary = ["grid.cells=[16,56],[24,84]", "nonlocal.length=0,1.5e-3"]

Examples
  riedel compare --schemes gimp,cpdi --vary nonlocal.length=0,1.5mm --dry-run
  riedel compare mine.toml --schemes all --out results/schemes
  riedel compare --set test=triaxial --vary specimen.void_ratio=0.6,0.75,0.9
  riedel compare mine.toml --schemes all --script slurm     then sbatch, and finally: riedel collect results/mine
)";
}

} // namespace

Command compare_command() {
  return {.name = "compare",
          .usage = "[CASE.toml] [options]",
          .summary = "The same case under many schemes and settings, several at once, with a report.",
          .max_words = 1,
          .options = compare_options(),
          .run = compare,
          .more_help = compare_help};
}

Command collect_command() {
  return {.name = "collect",
          .usage = "DIR",
          .summary = "Collects the results of a campaign that was run by script or not completed.",
          .max_words = 1,
          .options = {},
          .run = collect};
}

} // namespace riedel
