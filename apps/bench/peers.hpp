/// The cases in which other programs were measured, and their figures.
#pragma once

#include "apps/bench/measure.hpp"

#include <nlohmann/json_fwd.hpp>

namespace riedel {

std::vector<BenchCase> peer_cases();

/// Riedel's figures beside theirs, which come from another machine.
std::string peers_table(const std::vector<BenchResult>& results);
/// Adds `peers_ns` to the rows of `results_json`.
void add_peers(nlohmann::ordered_json& rows, const std::vector<BenchResult>& results);

} // namespace riedel
