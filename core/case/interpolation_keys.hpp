/// The options of the interpolation schemes as keys of a case.
#pragma once

#include "core/case/checked_case.hpp"
#include "core/interface/catalogue.hpp"

namespace riedel {

/// `interpolation.NAME` for every option of any scheme, once each.
Keys interpolation_keys(const Catalogue& catalogue);

/// Checks that the scheme of a case takes the options set. Defaults pass, since a run writes them to its case.toml.
void check_interpolation(const Values& values, const Catalogue& catalogue, std::vector<Finding>& errors);

} // namespace riedel
