/// The keys of a biaxial case: one table that makes the validator, `--help`, `riedel list`, the reference and the
/// schema.
#pragma once

#include "core/interface/catalogue.hpp"
#include "core/io/case_file.hpp"

namespace riedel {

/// Every default is the paper's value: Krzyżanowski, Wójcik & Tejchman (2020).
/// @param model the law whose parameters are appended as `material.<name>`; for an unknown law, those of all laws, so
/// that the law's name is the only error
Keys biaxial_keys(const Catalogue& catalogue, std::string_view model);

/// The law of the paper.
inline constexpr std::string_view paper_model = "gudehus_bauer";

/// What one key cannot see: errors stop the run, warnings are told.
struct BiaxialFindings {
  std::vector<Finding> errors, warnings;
};
BiaxialFindings check_biaxial(const Values& values);

/// A case that is fit to run.
struct BiaxialCase {
  Keys keys;
  Values values;
  std::vector<std::string> warnings; ///< each with its place
};

/// @throws InputError with a line for everything that is wrong
BiaxialCase biaxial_case(const CaseFile& given, const Catalogue& catalogue);

} // namespace riedel
