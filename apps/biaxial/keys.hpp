/// The keys of a biaxial case: one table for the validator, `--help`, `riedel list`, the reference and the schema.
#pragma once

#include "apps/biaxial/case.hpp"
#include "apps/paper_model.hpp"
#include "core/case/checked_case.hpp"
#include "core/case/material_keys.hpp"

namespace riedel {

/// Every default is the paper's value: Krzyżanowski, Wójcik & Tejchman (2020).
/// @param model the law whose parameters are appended as `material.<name>`; for an unknown law, those of all laws, so
/// that the law's name is the only error
Keys biaxial_keys(const Catalogue& catalogue, std::string_view model);

/// Checks that concern several keys.
Diagnostics check_biaxial(const BiaxialCase& values, const Catalogue& catalogue);

/// @throws InputError with a line for every error
CheckedCase biaxial_case(const CaseFile& given, const Catalogue& catalogue);

} // namespace riedel
