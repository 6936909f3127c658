#include "core/case/checked_case.hpp"

#include "core/base/error.hpp"

#include <algorithm>
#include <cmath>

namespace riedel {

namespace {

bool concerns(const Finding& finding, const std::vector<Finding>& errors) {
  return std::ranges::any_of(errors, [&](const Finding& error) {
    return std::ranges::find(finding.keys, error.keys.front()) != finding.keys.end();
  });
}

} // namespace

CheckedCase checked_case(const CaseFile& given, Keys keys, const std::function<Diagnostics(const Values&)>& check,
                         const std::function<void(std::vector<Finding>&)>& explain) {
  CheckedValues checked = given.check(keys);
  explain(checked.errors);
  const Diagnostics found = check(checked.values);
  std::vector<Finding> errors = checked.errors;
  for (const Finding& error : found.errors) // a wrong key has its default here, which needs no message
    if (!concerns(error, checked.errors)) errors.push_back(error);
  if (!errors.empty()) throw InputError(given.lines(errors));
  CheckedCase result{.keys = std::move(keys), .values = std::move(checked.values), .warnings = {}};
  for (const Finding& warning : found.warnings) result.warnings.push_back(given.lines({warning}));
  return result;
}

std::string rounded(double x) {
  const double unit = std::pow(10.0, 4 - static_cast<int>(std::ceil(std::log10(std::max(std::abs(x), 1e-300)))));
  return exact_text(std::round(x * unit) / unit);
}

} // namespace riedel
