/// What a run of the biaxial test will take.
#pragma once

#include "core/base/thread_choice.hpp"
#include "core/interface/catalogue.hpp"

namespace riedel {

/// Points, steps and time, cells, memory and threads, as comments behind a case.
std::string biaxial_outlook(const Values& values, const Catalogue& catalogue, ThreadRange threads);

} // namespace riedel
