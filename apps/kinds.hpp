/// The kinds of cases: one line each in a table.
#pragma once

#include "core/campaign/run_kind.hpp"

namespace riedel {

RunKind biaxial_kind();
RunKind element_kind();

std::span<const RunKind> run_kinds();

/// By the name of its sub-command.
const RunKind& run_kind(const std::string& name);
/// The kind of a case; a case that names no test is a biaxial one.
const RunKind& kind_of(const CaseFile& given);

} // namespace riedel
