/// The expected cost of a biaxial test.
#pragma once

#include "apps/biaxial/case.hpp"
#include "core/base/thread_choice.hpp"
#include "core/interface/catalogue.hpp"

namespace riedel {

/// Points, steps and time, cells, memory and threads, as comments after a case.
std::string biaxial_outlook(const BiaxialCase& values, const Catalogue& catalogue, ThreadRange threads);

} // namespace riedel
