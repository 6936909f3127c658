/// The text of `--help` about the keys of a case.
#pragma once

#include "core/case/case_file.hpp"
#include "core/interface/catalogue.hpp"

namespace riedel {

/// The keys of a case as a table for a terminal, for the law and the scheme that it names.
/// @throws InputError for an unknown law, scheme or test
std::string case_help(const CaseFile& given, const Keys& keys, const Catalogue& catalogue);

/// An unknown name has no keys to show. @throws InputError for an unknown law, scheme or test
void refuse_unknown_names(const CaseFile& given, const Keys& keys);

} // namespace riedel
