/// Keys of a case that have no effect on its run.
#pragma once

#include "core/case/checked_case.hpp"

namespace riedel {

/// Warns of keys that were given, with another value than their default, and have no effect because of others: a search
/// for neighbours in a local run, a seed without a random field. The case.toml that a run writes causes no warning.
/// @param keys with the defaults in force
void check_idle_keys(const CaseFile& given, const Keys& keys, const Values& values, std::vector<Finding>& warnings);

/// Was this key given, with another value than its default?
bool is_set(const CaseFile& given, const Keys& keys, const Values& values, const std::string& key);

} // namespace riedel
