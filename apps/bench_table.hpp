/// The figures of `riedel bench` as tables, which are Markdown as well, and as JSON.
#pragma once

#include "apps/bench_machine.hpp"
#include "apps/bench_measure.hpp"

#include <nlohmann/json_fwd.hpp>

namespace riedel {

using Row = std::vector<std::string>;
/// Columns as wide as their widest entry; the first `left` of them stand to the left, numbers to the right.
std::string markdown_table(const Row& head, const std::vector<Row>& rows, std::size_t left);

/// 93.4 or 1093: three digits at least.
std::string figure(double x);

std::string results_table(const std::vector<BenchResult>& results);
std::string phases_table(const std::vector<BenchResult>& results);
std::string machine_tables(const MachineLimits& limits, const BareKernelTimes& bare);

nlohmann::ordered_json results_json(const std::vector<BenchResult>& results);
nlohmann::ordered_json machine_json(const MachineLimits& limits, const BareKernelTimes& bare);

} // namespace riedel
