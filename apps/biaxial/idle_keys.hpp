/// Keys that a case gives and that nothing in the run looks at.
#pragma once

#include "core/case/checked_case.hpp"

namespace riedel {

/// Warns of keys that were given, with another value than their default, beside others that make them idle: a search
/// for neighbours in a local run, a seed without a random field. The keys that a run leaves in its case.toml pass.
/// @param keys with the defaults in force
void check_idle_keys(const CaseFile& given, const Keys& keys, const Values& values, std::vector<Finding>& warnings);

/// Was this key given, with another value than its default?
bool is_set(const CaseFile& given, const Keys& keys, const Values& values, const std::string& key);

} // namespace riedel
