/// Runs the unfinished runs of a campaign, several at a time.
#pragma once

#include "core/campaign/run_result.hpp"

#include <functional>

namespace riedel {

struct CampaignOptions {
  std::string command; ///< shown before the progress, such as "compare"
  int threads = 1;     ///< of all runs together; if there are fewer runs than threads, they share the threads
  std::function<bool()>
      stop; ///< checked many times a second; the runs are asked to stop, and keep their results so far
};

/// Runs that are done or have failed stay as they are; all others start from the beginning, those with the most work
/// first, each as its own process. Nothing that a run does, not even a crash, ends the others.
/// @throws RunError if the disk is full: the other runs are stopped, finished ones are kept
void run_campaign(const Plan& plan, const std::filesystem::path& folder, const CampaignOptions& how);

} // namespace riedel
