/// Whether a run stays quasi-static and its time step stable: looked at now and then, told in the summary.
#pragma once

#include "core/step/simulation.hpp"

#include <limits>

namespace riedel {

/// The greatest kinetic over internal energy.
class KineticShare {
public:
  static constexpr double settled = 0.005; ///< strain before which the internal energy is too small to compare with

  void record(double strain, const Energies& now);
  [[nodiscard]] double maximum() const { return maximum_; } ///< not a number before `settled` [-]

private:
  double maximum_ = std::numeric_limits<double>::quiet_NaN();
};

/// The greatest time step over the stable one. Warns once when a fixed step exceeds it.
class TimeStepWatch {
public:
  template <int Dim>
  void record(const Simulation<Dim>& simulation) {
    record(simulation.time_step(), simulation.crossing_time(), simulation.state().step);
  }
  [[nodiscard]] double maximum() const { return maximum_; } ///< [-]
  /// "" or what to know before believing the numbers.
  [[nodiscard]] std::string doubt() const;

private:
  void record(double time_step, double limit, std::int64_t step);

  double maximum_ = 0.0;
};

} // namespace riedel
