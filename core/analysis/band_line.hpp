/// The line along which a shear band runs, fitted to the points of the band.
#pragma once

#include "core/base/types.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace riedel {

/// A point as used by the measurement.
struct BandSample {
  Vec<2> x;        ///< [m]
  double volume;   ///< [m²]
  double e;        ///< void ratio [-]
  double rise;     ///< e − e0, minus the median over the specimen [-]
  double rotation; ///< minus the median over the specimen [rad]
  double shear;    ///< [-] or [1/s]
  double rate;     ///< ‖D‖, minus the median over the specimen [1/s]
  int band = 0;    ///< +1, −1: in the band that rotates anticlockwise, clockwise; 0: in none
};
using BandSamples = std::vector<BandSample>;

/// The weighted quantile: the value below which `share` of the weight lies.
template <class Value, class Weight>
double quantile(BandSamples samples, double share, const Value& value, const Weight& weight) {
  if (samples.empty()) return 0.0;
  std::ranges::sort(samples, {}, value);
  double total = 0.0, sum = 0.0;
  for (const BandSample& s : samples) total += weight(s);
  for (const BandSample& s : samples)
    if ((sum += weight(s)) >= share * total) return value(s);
  return value(samples.back());
}

template <class Keep>
BandSamples select(const BandSamples& samples, const Keep& keep) {
  BandSamples kept;
  std::ranges::copy_if(samples, std::back_inserter(kept), keep);
  return kept;
}

/// Standard deviation of a normal distribution over its median absolute deviation.
constexpr double normal_deviation = 1.4826;

/// The weight of a point in a band: V (e − e0) [m²].
inline double dilation(const BandSample& s) { return s.volume * s.rise; }

/// Centre and direction of a band, and the part that was followed.
struct BandLine {
  Vec<2> centre = Vec<2>::Zero(); ///< [m]
  double angle = 0.0;             ///< to the horizontal, −π/2 to π/2 [rad]
  double spread = 0.0;            ///< standard deviation across [m]
  double begin = 0.0, end = 0.0;  ///< of the straight part, along the line from the centre [m]

  [[nodiscard]] double along(const Vec<2>& x) const {
    return std::cos(angle) * (x - centre)[0] + std::sin(angle) * (x - centre)[1];
  }
  [[nodiscard]] double across(const Vec<2>& x) const {
    return std::cos(angle) * (x - centre)[1] - std::sin(angle) * (x - centre)[0];
  }
  [[nodiscard]] double along(const BandSample& s) const { return along(s.x); }
  [[nodiscard]] double across(const BandSample& s) const { return across(s.x); }
  [[nodiscard]] bool near(const BandSample& s) const { return std::abs(across(s)) <= 3.0 * spread; }
  [[nodiscard]] bool beside(const BandSample& s) const { return begin <= along(s) && along(s) <= end; }
};

/// Fits the line to the points of one band, all of them dilating. If there is no direction, `end` is not greater than
/// `begin`.
[[nodiscard]] BandLine fit_line(const BandSamples& band);

} // namespace riedel
