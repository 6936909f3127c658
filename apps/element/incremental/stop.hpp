/// The condition after a question mark in test.inp of IncrementalDriver: "s1 < -200" ends a step early.
#pragma once

#include "apps/element/incremental/input_lines.hpp"

namespace riedel {

/// The same limit in the form of a path, such as "sigma_1 > 200000.0 Pa".
/// @param stress_unit of the file [Pa]   @throws InputError with file and line for a component that paths do not have
std::string incremental_stop(const InputLines& at, const std::string& condition, double stress_unit);

} // namespace riedel
