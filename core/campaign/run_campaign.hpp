/// Runs what a campaign lacks, several at once.
#pragma once

#include "core/campaign/run_result.hpp"

#include <functional>

namespace riedel {

struct CampaignOptions {
  std::string command;        ///< before the progress, such as "compare"
  int threads = 1;            ///< of all runs together; fewer runs than threads share them out
  std::function<bool()> stop; ///< asked many times a second; the runs are told to stop, and keep what they have
};

/// Runs that are done or failed stay as they are; all others start from their beginning, those with the most work
/// first, each as a process of its own. Nothing that a run does, a crash included, is the others' end.
/// @throws RunError when the disk is full: the other runs are stopped, finished ones stay
void run_campaign(const Plan& plan, const std::filesystem::path& folder, const CampaignOptions& how);

} // namespace riedel
