/// campaign.json: what a folder's campaign consists of, every case with it.
#pragma once

#include "apps/campaign/plan.hpp"

#include <filesystem>

namespace riedel {

/// Makes the folder hold this campaign. An empty or new folder receives it; one that holds the same runs already is
/// taken up where it was left. With `force`, what another campaign left is removed.
/// @throws InputError that names the other campaign, or the other results, that the folder holds
void open_campaign(const std::filesystem::path& folder, const Plan& plan, bool force);

/// @throws InputError when the folder holds none, or one whose record cannot be understood
Plan read_campaign(const std::filesystem::path& folder);

} // namespace riedel
