/// Biaxial cases for tests, from the settings that a user would give with `--set`.
#pragma once

#include "apps/biaxial/keys.hpp"
#include "apps/biaxial/specimen.hpp"
#include "support/problems.hpp"

namespace riedel::test {

/// The paper's case with `settings` over it.
inline BiaxialCase biaxial_values(const std::vector<std::string>& settings) {
  CaseFile file = CaseFile::empty();
  for (const std::string& setting : settings) file.override_with(setting);
  return BiaxialCase(biaxial_case(file, catalogue()).values);
}

/// The same on a quarter of the default's cells; `more` takes precedence.
inline BiaxialCase coarse_values(const std::vector<std::string>& more = {}) {
  std::vector<std::string> settings{"grid.cells=[12, 42]", "nonlocal.length=3.4e-3"};
  settings.insert(settings.end(), more.begin(), more.end());
  return biaxial_values(settings);
}

} // namespace riedel::test
