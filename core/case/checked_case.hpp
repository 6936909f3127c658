/// A case that has passed its table of keys and the checks that involve several keys.
#pragma once

#include "core/case/case_file.hpp"

#include <functional>

namespace riedel {

/// Findings that involve several keys: errors stop the run, warnings are reported.
struct Diagnostics {
  std::vector<Finding> errors, warnings;
};

/// A valid case.
struct CheckedCase {
  Keys keys;
  Values values;
  std::vector<std::string> warnings;   ///< each with its place
  std::vector<std::string> notes = {}; ///< how a default was set, and why
};

/// @param check checks all values together @param explain adds to the messages about single keys
/// @throws InputError with one line per error
CheckedCase checked_case(const CaseFile& given, Keys keys, const std::function<Diagnostics(const Values&)>& check,
                         const std::function<void(std::vector<Finding>&)>& explain);

/// For messages: rounded to four digits.
std::string rounded(double x);

} // namespace riedel
