/// Checks of a path that concern several keys.
#pragma once

#include "apps/element/path.hpp"
#include "core/case/checked_case.hpp"

namespace riedel {

/// Six conditions in each leg or a deformation gradient, limits that can be read, at least one stage.
void check_path(const ElementCase& given, std::vector<Finding>& errors);

/// A path that is not ended early must not need more rows than can be kept.
/// @param every strain between rows [-]
void check_rows(double every, const ElementPath& path, std::vector<Finding>& errors);

} // namespace riedel
