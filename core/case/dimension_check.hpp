/// Checks that everything a case names is available in its number of dimensions.
#pragma once

#include "core/case/checked_case.hpp"
#include "core/interface/catalogue.hpp"

namespace riedel {

/// Checks scheme, search, averager and transfer. The choices of their keys are the names in two dimensions.
void check_offered(const Values& values, const Catalogue& catalogue, int dimensions, std::vector<Finding>& errors);

} // namespace riedel
