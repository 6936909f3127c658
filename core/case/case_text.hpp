/// Writes a case: every key in force, with a comment that says what it is.
#pragma once

#include "core/base/parameters.hpp"

namespace riedel {

/// A value as TOML; numbers read back to the same bits.
std::string toml_text(const Value& value);

/// A whole case. Reading it back gives the same values, to the bit.
std::string case_text(const Keys& keys, const Values& values);

} // namespace riedel
