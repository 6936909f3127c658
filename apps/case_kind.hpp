/// Which command a case is for: `riedel biaxial` or `riedel element`.
#pragma once

#include "core/case/checked_case.hpp"
#include "core/interface/catalogue.hpp"

namespace riedel {

/// Adds to unknown keys without another explanation where the known ones are listed.
void tell_where_keys_are_listed(std::vector<Finding>& errors, const std::string& command);

/// Explains the unknown keys of a biaxial case: it names the element test that takes them, or says where the known keys
/// are listed.
void explain_unknown_biaxial_keys(const CaseFile& given, const Catalogue& catalogue, std::vector<Finding>& errors);

/// The same for a case of `riedel element`, whose unknown keys may belong to `riedel biaxial`.
void explain_unknown_element_keys(const CaseFile& given, const std::string& test, const Catalogue& catalogue,
                                  std::vector<Finding>& errors);

/// Leaves out the keys that only `riedel biaxial` or `riedel element` takes, so that the case of a run can be given.
void leave_keys_of_runs(const CaseFile& given, const Catalogue& catalogue, std::vector<Finding>& errors);

} // namespace riedel
