/// The figures of `riedel bench` as tables, which are Markdown as well, and as JSON.
#pragma once

#include "apps/bench/machine.hpp"
#include "apps/bench/measure.hpp"
#include "core/io/markdown_table.hpp"

#include <nlohmann/json_fwd.hpp>

namespace riedel {

using Row = TableRow;

std::string results_table(const std::vector<BenchResult>& results);
std::string phases_table(const std::vector<BenchResult>& results);
std::string machine_tables(const MachineLimits& limits, const BareKernelTimes& bare);

nlohmann::ordered_json results_json(const std::vector<BenchResult>& results);
nlohmann::ordered_json machine_json(const MachineLimits& limits, const BareKernelTimes& bare);

} // namespace riedel
