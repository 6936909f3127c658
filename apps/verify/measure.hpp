/// What the problems are measured with: a watch, and the norm of an error.
#pragma once

#include "apps/verify/block.hpp"

#include <chrono>

namespace riedel {

/// Steps a simulation, sums up the time it took, and stops when it is told to.
class Watch {
public:
  explicit Watch(const VerifyCase& given) : stop_(given.stop) {}

  template <int Dim>
  void step(Simulation<Dim>& simulation) {
    if (stop_ && stop_()) throw VerifyStopped{};
    const auto start = std::chrono::steady_clock::now();
    simulation.step();
    seconds_ += std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    point_steps_ += simulation.state().bodies.front().points.size();
  }
  [[nodiscard]] double ns() const { return 1e9 * seconds_ / point_steps_; } ///< per point and step

private:
  std::function<bool()> stop_;
  double seconds_ = 0.0, point_steps_ = 0.0;
};

/// Relative L2 norm of an error over points, and over time when it is added to step by step.
class ErrorNorm {
public:
  void add(double weight, double difference_squared, double exact_squared) {
    squared_ += weight * difference_squared;
    whole_ += weight * exact_squared;
  }
  [[nodiscard]] double value() const { return std::sqrt(squared_ / whole_); }

private:
  double squared_ = 0.0, whole_ = 0.0;
};

} // namespace riedel
