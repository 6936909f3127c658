/// What a run of a case will take, before it begins.
#pragma once

#include "core/base/thread_choice.hpp"
#include "core/interface/catalogue.hpp"

namespace riedel {

/// Points, steps and time, cells, memory and threads of a biaxial case, as comments behind a case.
std::string biaxial_outlook(const Values& values, const Catalogue& catalogue, ThreadRange threads);

/// The same of an element test; of one at a point there is little to tell.
std::string element_outlook(const Values& values, const Catalogue& catalogue, ThreadRange threads);

} // namespace riedel
