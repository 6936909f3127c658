/// Tables and pictures of runs of element tests.
#pragma once

#include "core/campaign/run_result.hpp"

namespace riedel {

/// Strength, and the state at the end.
PageTable element_table(Runs runs);

/// The pictures of one test; none if the runs are of different tests or have no curve.
std::vector<NamedPlot> element_run_plots(Runs runs, const std::string& subject);

/// Strength and final state of a completed run, in one line.
std::string element_outcome(const nlohmann::ordered_json& summary);

/// Checks what the tables need of the summary of a completed run. @throws InputError
void check_element_summary(const nlohmann::ordered_json& summary);

} // namespace riedel
