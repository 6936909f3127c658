/// What `--help` says of the keys of a case.
#pragma once

#include "core/case/case_file.hpp"
#include "core/interface/catalogue.hpp"

namespace riedel {

/// The keys of a case as a table for a terminal, of the law and the scheme that it names.
/// @throws InputError for a law, scheme or test that is not known
std::string case_help(const CaseFile& given, const Keys& keys, const Catalogue& catalogue);

/// A name that is wrong has no keys to show. @throws InputError for a law, scheme or test that is not known
void refuse_unknown_names(const CaseFile& given, const Keys& keys);

} // namespace riedel
