/// Checks whether a run stays quasi-static and its time step stable: sampled at intervals, reported in the summary.
#pragma once

#include "core/step/simulation.hpp"

#include <limits>

namespace riedel {

/// The largest ratio of kinetic to internal energy.
class KineticShare {
public:
  static constexpr double settled = 0.005; ///< strain below which the internal energy is too small for comparison

  void record(double strain, const Energies& now);
  [[nodiscard]] double maximum() const { return maximum_; } ///< NaN before `settled` [-]

private:
  double maximum_ = std::numeric_limits<double>::quiet_NaN();
};

/// The largest ratio of time step to stable time step. Warns once if a fixed step exceeds it.
class TimeStepWatch {
public:
  template <int Dim>
  void record(const Simulation<Dim>& simulation) {
    record(simulation.time_step(), simulation.crossing_time(), simulation.state().step);
  }
  [[nodiscard]] double maximum() const { return maximum_; } ///< [-]
  /// Empty, or a warning about the reliability of the results.
  [[nodiscard]] std::string doubt() const;

private:
  void record(double time_step, double limit, std::int64_t step);

  double maximum_ = 0.0;
};

} // namespace riedel
