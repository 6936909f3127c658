/// The expected cost of an element test.
#pragma once

#include "core/case/case_kind.hpp"

namespace riedel {

/// Points, steps, cells and threads, as comments after a case; a single line for a test at one point.
std::string element_outlook(const Values& values, const Catalogue& catalogue, ThreadRange threads);

ExpectedRun expected_element(const Values& values, const Catalogue& catalogue);

} // namespace riedel
