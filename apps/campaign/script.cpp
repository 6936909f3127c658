#include "apps/campaign/script.hpp"

#include "apps/shell_word.hpp"
#include "core/base/error.hpp"
#include "core/io/atomic_file.hpp"

namespace riedel {

namespace {

namespace fs = std::filesystem;

/// Calls what RIEDEL names, or else this program.
/// @param how "exec " or nothing
std::string call(const std::string& how) {
  return "program=" + shell_word(fs::read_symlink("/proc/self/exe").string()) + " && " + how +
         "\"${RIEDEL:-$program}\" biaxial ";
}

/// A place that is given whole; the slash lets any name be a word.
std::string word_of(const fs::path& folder) { return shell_word((folder / "").string()); }

std::vector<fs::path> write_cases(const Plan& plan, const fs::path& folder) {
  std::vector<fs::path> folders;
  for (const std::size_t i : longest_first(plan)) {
    folders.push_back(fs::absolute(folder / plan.runs[i].name));
    fs::create_directories(folders.back());
    write_atomically(folders.back() / "case.toml", plan.runs[i].case_text);
  }
  return folders;
}

std::string slurm_script(const std::vector<fs::path>& folders, const fs::path& campaign) {
  std::string text = "#!/bin/bash\n"
                     "# sbatch " +
                     shell_word((campaign / "campaign.slurm").string()) +
                     "\n"
                     "#SBATCH --job-name=riedel\n"
                     "#SBATCH --array=0-" +
                     std::to_string(folders.size() - 1) +
                     "\n"
                     "#SBATCH --ntasks=1\n"
                     "#SBATCH --cpus-per-task=1\n"
                     "runs=(\n";
  for (const fs::path& folder : folders) text += "  " + word_of(folder) + "\n";
  return text +
         ")\n"
         "run=${runs[$SLURM_ARRAY_TASK_ID]}\n"
         "cd " +
         word_of(fs::current_path()) + " && " + call("exec ") +
         "\"${run}case.toml\" --out \"$run\" --force --threads \"${SLURM_CPUS_PER_TASK:-1}\"\n";
}

std::string parallel_file(const std::vector<fs::path>& folders, const fs::path& campaign) {
  std::string text =
      "# parallel --joblog jobs.log --resume < " + shell_word((campaign / "campaign.parallel").string()) + "\n";
  for (const fs::path& folder : folders)
    text += "cd " + word_of(fs::current_path()) + " && " + call("") + shell_word((folder / "case.toml").string()) +
            " --out " + word_of(folder) + " --force --threads 1\n";
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
    const std::vector<fs::path> folders = write_cases(plan, campaign);
    write_atomically(script, kind == "slurm" ? slurm_script(folders, campaign) : parallel_file(folders, campaign));
  } catch (const fs::filesystem_error& error) {
    throw RunError(campaign.string() + ": cannot be written to: " + error.code().message());
  }
  return script;
}

} // namespace riedel
