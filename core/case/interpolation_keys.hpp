/// The options of the interpolation schemes as keys of a case.
#pragma once

#include "core/case/checked_case.hpp"
#include "core/interface/catalogue.hpp"

namespace riedel {

/// `interpolation.NAME` for every option of any scheme, each once.
Keys interpolation_keys(const Catalogue& catalogue);

/// Whether the scheme of a case takes the options that are set. Defaults pass: a run leaves them in its case.toml.
void check_interpolation(const Values& values, const Catalogue& catalogue, std::vector<Finding>& errors);

} // namespace riedel
