/// campaign.json: what a folder's campaign consists of, every case with it.
#pragma once

#include "core/campaign/plan.hpp"
#include "core/run/output_folder.hpp"

namespace riedel {

/// All kinds that a campaign may be of.
using RunKinds = std::span<const RunKind>;

/// A folder that holds a campaign, this process's own while it lives.
struct OpenCampaign {
  OutputFolder folder;
  Plan plan; ///< the runs that were asked for, and behind them those that the folder held before
};

/// Makes the folder hold this campaign. An empty or new folder receives it. One that holds a campaign with the same
/// case in a run of the same name takes the other runs in as well: what is finished stays, whatever more is asked for.
/// With `force`, what another campaign left is removed.
/// @throws InputError that names the other campaign, or the other results, that the folder holds, or who writes to it
OpenCampaign open_campaign(const std::filesystem::path& folder, const Plan& plan, bool force, RunKinds kinds);

/// @throws InputError when the folder holds none, or one whose record cannot be understood
Plan read_campaign(const std::filesystem::path& folder, RunKinds kinds);

} // namespace riedel
