/// What runs of element tests look like in tables.
#pragma once

#include "core/campaign/run_result.hpp"

namespace riedel {

/// Strength, and the state at the end.
PageTable element_table(Runs runs);

/// The pictures of one test; none where the runs differ in it, or have left no curve.
std::vector<NamedPlot> element_run_plots(Runs runs, const std::string& subject);

/// The same of a run that is done, in one line.
std::string element_outcome(const nlohmann::ordered_json& summary);

/// What tables take for granted of the summary of a run that is done. @throws InputError
void check_element_summary(const nlohmann::ordered_json& summary);

} // namespace riedel
