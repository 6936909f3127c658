/// report.html of a campaign.
#pragma once

#include "apps/report/run_views.hpp"

namespace riedel {

/// Who made the results, for the head of a page.
std::vector<std::pair<std::string, std::string>> provenance(const std::string& command, Runs runs);

/// Curves, fields, tables of everything that the campaign's folder holds.
Page compare_report(const std::string& title, const std::string& command, Runs runs);

} // namespace riedel
