/// The keys of an element test: one table for the validator, `--help`, the reference and the schema.
#pragma once

#include "apps/paper_model.hpp"
#include "core/case/checked_case.hpp"
#include "core/case/material_keys.hpp"

namespace riedel {

/// The tests of the paper, plane strain compression, and any path that the case describes.
const std::vector<std::string>& element_tests();

/// The test of a case that names none.
inline constexpr const char* usual_element_test = "triaxial";

/// Default of `material.tolerance`: a single point is cheap, so its law is integrated more accurately than on a grid.
inline constexpr double element_law_tolerance = 1e-7;

/// Every default is the paper's value, or one that reproduces its figures.
/// @param test one of `element_tests()`   @param model the law whose parameters are appended
Keys element_keys(const Catalogue& catalogue, const std::string& test, std::string_view model);

/// The element test that a case names, if any.
std::optional<std::string> test_of(const CaseFile& given);

/// @throws InputError with a line for every error
CheckedCase element_case(const CaseFile& given, const Catalogue& catalogue);

} // namespace riedel
