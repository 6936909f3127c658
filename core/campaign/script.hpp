/// Writes the runs of a campaign as a script for machines with more cores.
#pragma once

#include "core/campaign/plan.hpp"

#include <filesystem>

namespace riedel {

/// The available kinds: "slurm", an sbatch array, and "parallel", one line per run for GNU parallel.
const std::vector<std::string>& script_kinds();

/// Writes the case of every run that can start, and the script, in which the runs with the most work come first. The
/// script calls this program by its current path, or by RIEDEL if that is set, from the current folder.
/// @return the script's path   @throws RunError
std::filesystem::path write_script(const std::string& kind, const Plan& plan, const std::filesystem::path& folder);

} // namespace riedel
