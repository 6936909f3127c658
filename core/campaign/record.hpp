/// campaign.json: what the campaign in a folder consists of, with every case.
#pragma once

#include "core/campaign/plan.hpp"
#include "core/run/output_folder.hpp"

namespace riedel {

/// All kinds of case that a campaign may consist of.
using RunKinds = std::span<const RunKind>;

/// A folder that holds a campaign, locked by this process during its lifetime.
struct OpenCampaign {
  OutputFolder folder;
  Plan plan; ///< the requested runs, followed by those that were in the folder before
};

/// Prepares the folder for this campaign. A new or empty folder is filled. If it holds a campaign that has a run of the
/// same name with the same case, the other runs are added: finished runs stay, whatever else is requested. With
/// `force`, the files of another campaign are removed.
/// @throws InputError that names the other campaign or results in the folder, or the process that writes to it
OpenCampaign open_campaign(const std::filesystem::path& folder, const Plan& plan, bool force, RunKinds kinds);

/// @throws InputError if the folder holds no campaign, or its record cannot be understood
Plan read_campaign(const std::filesystem::path& folder, RunKinds kinds);

} // namespace riedel
