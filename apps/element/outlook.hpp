/// What a run of an element test will take.
#pragma once

#include "core/case/case_kind.hpp"

namespace riedel {

/// Points, steps, cells and threads, as comments behind a case; of a test at one point there is little to tell.
std::string element_outlook(const Values& values, const Catalogue& catalogue, ThreadRange threads);

ExpectedRun expected_element(const Values& values, const Catalogue& catalogue);

} // namespace riedel
