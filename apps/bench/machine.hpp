/// What one core of this machine can do: the scale for every other figure.
#pragma once

#include "apps/bench/measure.hpp"
#include "core/base/machine.hpp"

namespace riedel {

/// Nanoseconds per point and step of the bare kernel with the hypoplastic law; bench_bare_kernel.hpp.
struct BareKernelTimes {
  static constexpr std::array points{4'096, 102'400};
  std::array<double, points.size()> linear{}, gimp{};
  /// The one for comparison: of the same kind and with the nearest number of points.
  [[nodiscard]] double nearest(bool wide, int points_of_case) const;
};
BareKernelTimes measure_bare_kernel(const BenchEffort& effort);

/// One rate at one point [ns].
struct LawTimes {
  std::string law;
  double pack = 0, scalar = 0;
};

struct MachineLimits {
  double triad_memory = 0, triad_l2 = 0; ///< a = b + s c, three arrays of 128 MB or 170 kB [GB/s]
  double fma = 0;                        ///< multiply-adds of packs in registers [GFLOP/s]
  double exp_pack = 0, exp_scalar = 0;   ///< per call [ns]
  double pow_pack = 0, pow_scalar = 0;   ///< per call [ns]
  std::vector<LawTimes> laws;            ///< hypoplastic, with intergranular strain and without
  /// Of the law for which the lower bounds of a step are given.
  [[nodiscard]] const LawTimes& bare_law() const { return laws.front(); }
};
MachineLimits measure_machine(const BenchEffort& effort);

} // namespace riedel
