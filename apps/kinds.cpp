#include "apps/kinds.hpp"

#include <algorithm>

namespace riedel {

std::span<const RunKind> run_kinds() {
  static const std::vector<RunKind> all{element_kind(), biaxial_kind()};
  return all;
}

const RunKind& run_kind(const std::string& name) {
  return *std::ranges::find(run_kinds(), name, [](const RunKind& kind) { return kind.cases.name; });
}

const RunKind& kind_of(const CaseFile& given) {
  return *std::ranges::find_if(run_kinds(), [&](const RunKind& kind) { return kind.cases.holds(given); });
}

} // namespace riedel
