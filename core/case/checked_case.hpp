/// A case that has passed its table of keys and the checks that no single key can make.
#pragma once

#include "core/case/case_file.hpp"

#include <functional>

namespace riedel {

/// What one key cannot see: errors stop the run, warnings are told.
struct Diagnostics {
  std::vector<Finding> errors, warnings;
};

/// A case that is fit to run.
struct CheckedCase {
  Keys keys;
  Values values;
  std::vector<std::string> warnings;   ///< each with its place
  std::vector<std::string> notes = {}; ///< what a default has become, and why
};

/// @param check looks at all values together   @param explain adds to what is said of single keys
/// @throws InputError with a line for everything that is wrong
CheckedCase checked_case(const CaseFile& given, Keys keys, const std::function<Diagnostics(const Values&)>& check,
                         const std::function<void(std::vector<Finding>&)>& explain);

/// For messages: rounded to four digits.
std::string rounded(double x);

} // namespace riedel
