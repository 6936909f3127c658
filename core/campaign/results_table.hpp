/// results.csv: one row per run.
#pragma once

#include "core/campaign/run_result.hpp"

namespace riedel {

/// Columns: run, status, reason, every varied key, every value of summary.json, those of the band as "band.…". A
/// missing value is an empty cell. Texts with commas or quotes are quoted.
std::string results_csv(const std::vector<RunResult>& results);

/// A short form for a terminal.
std::string results_text(const RunKind& kind, const std::vector<RunResult>& results);

} // namespace riedel
