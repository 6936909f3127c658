/// results.csv: a row per run.
#pragma once

#include "core/campaign/run_result.hpp"

namespace riedel {

/// Columns: run, status, reason, every varied key, every figure of summary.json, those of the band as "band.…". A run
/// without a figure has an empty cell. Texts with commas or quotes are quoted.
std::string results_csv(const std::vector<RunResult>& results);

/// The same in short, for a terminal.
std::string results_text(const RunKind& kind, const std::vector<RunResult>& results);

} // namespace riedel
