/// The runs of a campaign as a script for machines with more cores than this one.
#pragma once

#include "core/campaign/plan.hpp"

#include <filesystem>

namespace riedel {

/// The kinds there are: "slurm", an sbatch array, and "parallel", a line for each run for GNU parallel.
const std::vector<std::string>& script_kinds();

/// Writes the case of every run that can begin and the script, with the runs that have the most work first. The script
/// calls this program by its present place, or by RIEDEL if that is set, from the present folder.
/// @return the script's path   @throws RunError
std::filesystem::path write_script(const std::string& kind, const Plan& plan, const std::filesystem::path& folder);

} // namespace riedel
