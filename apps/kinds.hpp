/// The kinds of case that there are: a line each in one table.
#pragma once

#include "core/campaign/run_kind.hpp"

namespace riedel {

RunKind biaxial_kind();
RunKind element_kind();

std::span<const RunKind> run_kinds();

/// By the name of its sub-command.
const RunKind& run_kind(const std::string& name);
/// That of a case; the biaxial test is that of a case which says nothing.
const RunKind& kind_of(const CaseFile& given);

} // namespace riedel
