/// The cases that the options of `riedel bench` request.
#pragma once

#include "apps/bench/measure.hpp"
#include "apps/command_line.hpp"

namespace riedel {

Options bench_options();

/// Every combination of the lists given, defaults for those not given. Throws InputError.
std::vector<BenchCase> bench_cases(const Arguments& arguments, const Catalogue& catalogue);

/// --repeats and --seconds. Throws InputError.
BenchEffort bench_effort(const Arguments& arguments);

/// Throws InputError when options that choose cases are given beside `mode`, which has cases of its own.
void refuse_choices(const Arguments& arguments, const std::string& mode);

} // namespace riedel
