#include "core/campaign/script.hpp"

#include "core/base/error.hpp"
#include "core/io/atomic_file.hpp"
#include "core/io/shell_word.hpp"

#include <algorithm>

namespace riedel {

namespace {

namespace fs = std::filesystem;

/// Calls the program named by RIEDEL, otherwise this program.
/// @param how "exec " or empty
std::string call(const std::string& how, const std::string& words) {
  return "program=" + shell_word(fs::read_symlink("/proc/self/exe").string()) + " && " + how +
         "\"${RIEDEL:-$program}\" " + words + " ";
}

/// A run's folder, and the arguments of the command that runs it.
struct Place {
  fs::path folder;
  std::string words;
};

std::string words_of(const CaseKind& kind, const PlannedRun& run) {
  std::string all;
  for (const std::string& word : kind.words(run.given())) all += (all.empty() ? "" : " ") + shell_word(word);
  return all;
}

/// A complete path; the slash makes any name a safe argument.
std::string word_of(const fs::path& folder) { return shell_word((folder / "").string()); }

std::vector<Place> write_cases(const Plan& plan, const fs::path& folder) {
  std::vector<Place> places;
  for (const std::size_t i : longest_first(plan)) {
    const PlannedRun& run = plan.runs[i];
    places.push_back({fs::absolute(folder / run.name), words_of(plan.kind->cases, run)});
    fs::create_directories(places.back().folder);
    write_atomically(places.back().folder / "case.toml", run.case_text);
  }
  return places;
}

/// One common line if all are run alike; otherwise each has its own command.
std::string slurm_script(const std::vector<Place>& places, const fs::path& campaign) {
  std::string text = "#!/bin/bash\n"
                     "# sbatch " +
                     shell_word((campaign / "campaign.slurm").string()) +
                     "\n"
                     "#SBATCH --job-name=riedel\n"
                     "#SBATCH --array=0-" +
                     std::to_string(places.size() - 1) +
                     "\n"
                     "#SBATCH --ntasks=1\n"
                     "#SBATCH --cpus-per-task=1\n"
                     "runs=(\n";
  for (const Place& place : places) text += "  " + word_of(place.folder) + "\n";
  const bool alike = std::ranges::all_of(places, [&](const Place& p) { return p.words == places.front().words; });
  std::string words = places.front().words;
  if (!alike) {
    text += ")\ncommands=(\n";
    for (const Place& place : places) text += "  " + shell_word(place.words) + "\n";
    words = "${commands[$SLURM_ARRAY_TASK_ID]}";
  }
  return text +
         ")\n"
         "run=${runs[$SLURM_ARRAY_TASK_ID]}\n"
         "cd " +
         word_of(fs::current_path()) + " && " + call("exec ", words) +
         "\"${run}case.toml\" --out \"$run\" --force --threads \"${SLURM_CPUS_PER_TASK:-1}\"\n";
}

std::string parallel_file(const std::vector<Place>& places, const fs::path& campaign) {
  std::string text =
      "# parallel --joblog jobs.log --resume < " + shell_word((campaign / "campaign.parallel").string()) + "\n";
  for (const auto& [folder, words] : places)
    text += "cd " + word_of(fs::current_path()) + " && " + call("", words) +
            shell_word((folder / "case.toml").string()) + " --out " + word_of(folder) + " --force --threads 1\n";
  return text;
}

} // namespace

const std::vector<std::string>& script_kinds() {
  static const std::vector<std::string> kinds{"slurm", "parallel"};
  return kinds;
}

fs::path write_script(const std::string& kind, const Plan& plan, const fs::path& folder) {
  const fs::path campaign = fs::absolute(folder), script = campaign / ("campaign." + kind);
  try {
    const std::vector<Place> places = write_cases(plan, campaign);
    write_atomically(script, kind == "slurm" ? slurm_script(places, campaign) : parallel_file(places, campaign));
  } catch (const fs::filesystem_error& error) {
    throw RunError(campaign.string() + ": cannot be written to: " + error.code().message());
  }
  return script;
}

} // namespace riedel
