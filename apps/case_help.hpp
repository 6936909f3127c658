/// The keys of a case in `--help`, for the law, the scheme and the test that are named beside it.
#pragma once

#include "apps/command_line.hpp"

namespace riedel {

/// Keys of a biaxial case. @throws InputError for an unknown law, scheme or test, and for a case file that cannot be
/// read; PluginError
std::string biaxial_help(const Arguments& arguments);
/// Keys of the test that is the first word, or the tests when there is none.
std::string element_help(const Arguments& arguments);
/// Keys of a biaxial case, or of the element test that the case names.
std::string check_help(const Arguments& arguments);
std::string umat_check_help(const Arguments& arguments);

} // namespace riedel
