/// The norm of an error against an exact field.
#pragma once

#include <cmath>

namespace riedel {

/// Relative L2 norm of an error over points, and over time if accumulated over steps.
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
