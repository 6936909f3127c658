/// Which command a case is for: that of the biaxial test, or of an element test.
#pragma once

#include "core/case/checked_case.hpp"
#include "core/interface/catalogue.hpp"

namespace riedel {

/// Says of unknown keys, of which nothing else could be said, where the known ones are listed.
void tell_where_keys_are_listed(std::vector<Finding>& errors, const std::string& command);

/// What an unknown key of a biaxial case means: a key that an element test has is told to be one, all others are told
/// where the known ones are listed.
void explain_unknown_biaxial_keys(const CaseFile& given, const Catalogue& catalogue, std::vector<Finding>& errors);

/// The same for a case of `riedel element`, which may be one of `riedel biaxial`.
void explain_unknown_element_keys(const CaseFile& given, const std::string& test, const Catalogue& catalogue,
                                  std::vector<Finding>& errors);

/// Leaves out what a case has for the run that its law is to serve: keys that only `riedel biaxial` or `riedel element`
/// takes.
void leave_keys_of_runs(const CaseFile& given, const Catalogue& catalogue, std::vector<Finding>& errors);

} // namespace riedel
