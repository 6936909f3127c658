/// report.html of a campaign.
#pragma once

#include "core/campaign/run_views.hpp"

#include <filesystem>

namespace riedel {

/// Origin of the results, for the header of a page.
std::vector<std::pair<std::string, std::string>> provenance(const std::string& command, Runs runs);

/// Curves, fields and tables of everything in the campaign's folder.
Page campaign_report(const Plan& plan, Runs runs);

/// The same as PNG files in the campaign's folder: curves.png, and void_ratio_1.png, ... (mean_pressure, rate_norm)
/// with up to nine specimens each; runs that differ only in their scheme are side by side. @return their names
std::vector<std::string> write_campaign_pictures(const Plan& plan, Runs runs, const std::filesystem::path& folder);

} // namespace riedel
