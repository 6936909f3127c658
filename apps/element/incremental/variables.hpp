/// The six conditions of a step of IncrementalDriver, in its various variables.
#pragma once

#include <array>
#include <map>
#include <span>
#include <string>

namespace riedel {

/// One of the six: the measures of strain and stress, and the factors for the numbers of the file.
struct IncrementalPair {
  const char *strain, *stress;
  double strain_factor, stress_factor;

  [[nodiscard]] std::string name(bool is_stress) const { return is_stress ? stress : strain; }
  [[nodiscard]] double factor(bool is_stress, double stress_unit) const {
    return is_stress ? stress_factor * stress_unit : strain_factor;
  }
};
using IncrementalVariables = std::array<IncrementalPair, 6>;

/// By their keyword in small letters, such as "*roscoe".
const std::map<std::string, IncrementalVariables>& incremental_variables();

/// A keyword that stands for a linear load in which one component changes.
struct IncrementalShorthand {
  const char* keyword; ///< in small letters
  int changed;         ///< the component whose change follows; −1: none does
  std::array<bool, 6> is_stress;
  const char* variables;
};
std::span<const IncrementalShorthand> incremental_shorthands();

} // namespace riedel
