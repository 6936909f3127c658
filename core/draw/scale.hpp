/// Numbers along an axis: round ticks, short labels, colours of a colour bar.
#pragma once

#include "core/draw/canvas.hpp"

#include <limits>
#include <string>
#include <vector>

namespace riedel {

/// From low to high, in the unit of the axis.
struct Interval {
  double low = 0, high = 1;
  [[nodiscard]] double width() const { return high - low; }
  [[nodiscard]] double part(double value) const { return (value - low) / (high - low); } ///< 0 at low, 1 at high
};

/// The range of the given values, ignoring those that are not finite, or beyond what an axis can span (1e300).
class Extent {
public:
  void add(double value);
  /// Never of zero width. @param margin share of the width that is added on both sides; with a margin, a low end near
  /// zero becomes zero
  [[nodiscard]] Interval interval(double margin) const;

private:
  double low_ = std::numeric_limits<double>::infinity(), high_ = -low_;
};

/// Multiples of 1, 2 or 5 times a power of ten within the interval, about as many as requested; only its low end if it
/// is too narrow for ticks to differ as numbers.
std::vector<double> round_ticks(const Interval& interval, int about);

/// Ticks of a logarithmic axis: powers of ten within the interval of decimal logarithms; for a short interval also 2
/// and 5 times these, or round numbers; for a long one not every power. @return decimal logarithms
std::vector<double> log_ticks(const Interval& logarithms, int maximum = 10);

/// The label of each tick on a logarithmic axis.
std::vector<std::string> log_tick_labels(const std::vector<double>& ticks);

/// Labels of those ticks with just enough decimals to differ, and a true minus sign.
std::vector<std::string> tick_labels(const std::vector<double>& ticks);

/// A number with the fewest digits, such as "4", "0.55" or "2e−6".
std::string plain_number(double value);

/// The colour map viridis: dark purple at 0, yellow at 1, perceptually uniform, also in print and for the colour-blind.
Color viridis(double part);

} // namespace riedel
