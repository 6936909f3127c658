/// Measuring the problems: a stopwatch, and the norm of an error (core/analysis/error_norm.hpp).
#pragma once

#include "apps/verify/block.hpp"
#include "core/analysis/error_norm.hpp"
#include "core/run/run.hpp"

#include <ctime>

namespace riedel {

/// Sums up the time of the steps of runs, and ends a run on request. It is the time of the thread, so that other
/// processes on the machine have little effect.
class Watch {
public:
  explicit Watch(const VerifyCase& given) : stop_(given.stop) {}

  /// A run whose steps are timed; it ends by VerifyStopped when the user stops the program.
  template <int Dim>
  Run<Dim> run(Simulation<Dim>& simulation) {
    return Run<Dim>(simulation, [this, &simulation](const auto& step) {
      if (stop_ && stop_()) throw VerifyStopped{};
      const double start = now();
      step();
      spent_ += now() - start;
      point_steps_ += simulation.state().bodies.front().points.size();
    });
  }
  [[nodiscard]] double ns() const { return spent_ / point_steps_; } ///< per point and step

private:
  static double now() {
    timespec time{};
    ::clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
    return 1e9 * static_cast<double>(time.tv_sec) + static_cast<double>(time.tv_nsec);
  }

  std::function<bool()> stop_;
  double spent_ = 0.0, point_steps_ = 0.0; ///< time spent [ns]
};

} // namespace riedel
