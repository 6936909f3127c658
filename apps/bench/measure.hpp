/// Time and memory of one case.
#pragma once

#include "apps/bench/case.hpp"

#include <optional>

namespace riedel {

/// How long to measure, and when to stop.
struct BenchEffort {
  int repeats = 5;
  double seconds = 0.2; ///< minimum duration of a repeat
  std::function<bool()> stop = [] { return false; };
};

/// The spread of several values of one quantity.
struct Spread {
  double median = 0, minimum = 0, maximum = 0;
};
Spread spread_of(std::vector<double> values);

/// Nanoseconds are per point and step.
struct BenchResult {
  BenchCase of;
  Index points = 0;
  std::int64_t steps = 0;                          ///< in a repeat
  bool wide = false;                               ///< the supports of its points reach beyond their cells
  Spread ns{};                                     ///< without the phase clock
  std::array<double, phase_names.size()> phases{}; ///< [ns], measured in a separate repeat
  double bytes_per_point = 0;   ///< in use after a run, of everything: points, stencils, nodes, neighbours
  double substepped_share = 0;  ///< points whose step had to be divided, of all points and steps
  double ns_of_bare_kernel = 0; ///< what the ratio refers to; 0: there is no bare kernel of this kind
  [[nodiscard]] double ratio() const { return ns.median / ns_of_bare_kernel; }
};

/// @return nothing if it was stopped
std::optional<BenchResult> measure(const BenchCase& wanted, const Catalogue& catalogue, const BenchEffort& effort);

} // namespace riedel
