/// Writes a case: every key in force, with a comment that describes it.
#pragma once

#include "core/base/parameters.hpp"

namespace riedel {

/// A value as TOML; numbers read back identically to the bit.
std::string toml_text(const Value& value);

/// A complete case. Reading it back gives the same values, to the bit.
std::string case_text(const Keys& keys, const Values& values);

} // namespace riedel
