/// The path of an element test, from its case.
#pragma once

#include "apps/element/case.hpp"
#include "materials/element/path.hpp"

namespace riedel {

/// "p < 20 kPa" @throws InputError that states what is allowed
Stop parse_stop(const std::string& text);

/// The path of a case. @throws InputError for an invalid limit of a stage
ElementPath element_path(const ElementCase& given);

} // namespace riedel
