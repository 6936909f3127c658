#include "core/draw/scale.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

namespace riedel {

void Extent::add(double value) {
  constexpr double maximum = 1e300; // the width of the interval must not overflow
  if (!(std::abs(value) <= maximum)) return;
  low_ = std::min(low_, value);
  high_ = std::max(high_, value);
}

Interval Extent::interval(double margin) const {
  if (low_ > high_) return {0, 1};
  const double size = std::max(std::abs(low_), std::abs(high_));
  if (high_ - low_ <= 1e-12 * size || size < 1e-300) { // all equal, up to rounding
    const double half = size < 1e-300 ? 0.5 : 0.05 * size;
    return {low_ - half, high_ + half};
  }
  const double extra = margin * (high_ - low_);
  const bool from_zero = margin > 0 && low_ >= 0 && low_ < 0.3 * high_;
  return {from_zero ? 0 : low_ - extra, high_ + extra};
}

std::vector<double> round_ticks(const Interval& interval, int about) {
  const double rough = interval.width() / about, power = std::pow(10.0, std::floor(std::log10(rough)));
  double step = 10 * power;
  for (double factor : {5.0, 2.0, 1.0})
    if (factor * power >= 0.7 * rough) step = factor * power;
  const double size = std::max(std::abs(interval.low), std::abs(interval.high));
  if (!(step > 1e-15 * size)) return {interval.low};
  const double slack = 1e-9 * interval.width(), first = std::ceil((interval.low - slack) / step);
  std::vector<double> ticks;
  for (int k = 0; (first + k) * step <= interval.high + slack; ++k) ticks.push_back((first + k) * step);
  constexpr int maximum = 16; // a single tick does not show the scale
  return ticks.size() < 2 && 2 * about <= maximum ? round_ticks(interval, 2 * about) : ticks;
}

namespace {

/// A power of ten as shown in a label. @param decimals of the mantissa
std::string with_exponent(double mantissa, int exponent, int decimals) {
  std::array<char, 64> text{};
  std::snprintf(text.data(), text.size(), "%.*fe%s%d", decimals, mantissa, exponent < 0 ? "−" : "", std::abs(exponent));
  return text.data();
}

/// A positive number with at most this many digits.
std::string digits_of(double value, int digits) {
  std::array<char, 64> text{};
  std::snprintf(text.data(), text.size(), "%.*g", digits, value);
  std::string number = text.data();
  const std::size_t e = number.find('e');
  if (e == std::string::npos) return number;
  return number.substr(0, e) + with_exponent(0, std::stoi(number.substr(e + 1)), 0).substr(1);
}

} // namespace

std::string plain_number(double value) {
  if (!std::isfinite(value)) return "–";
  return (value < 0 ? "−" : "") + digits_of(std::abs(value), 6);
}

std::vector<std::string> tick_labels(const std::vector<double>& ticks) {
  double largest = 0;
  for (double tick : ticks) largest = std::max(largest, std::abs(tick));
  const double step = ticks.size() > 1 ? ticks[1] - ticks[0] : largest > 0 ? largest : 1.0;
  const bool powers = largest >= 1e5 || (largest > 0 && largest < 1e-3);
  const double unit = powers ? std::pow(10.0, std::floor(std::log10(largest) + 1e-9)) : 1;
  const int decimals = std::max(0, static_cast<int>(-std::floor(std::log10(step / unit) + 0.05)));

  std::vector<std::string> labels;
  for (double tick : ticks) {
    std::array<char, 64> text{};
    const double shown = std::abs(tick) < step / 2 ? 0 : std::abs(tick);
    std::snprintf(text.data(), text.size(), "%.*f", powers ? 0 : decimals, shown);
    const bool power = powers && shown > 0;
    const int exponent = power ? static_cast<int>(std::lround(std::log10(unit))) : 0;
    labels.push_back((shown > 0 && tick < 0 ? "−" : "") +
                     (power ? with_exponent(shown / unit, exponent, decimals) : std::string(text.data())));
  }
  return labels;
}

std::vector<double> log_ticks(const Interval& logarithms, int maximum) {
  constexpr double slack = 1e-9;
  const double decades = logarithms.width();
  const double stride = std::max(1.0, std::ceil(decades / maximum));
  std::vector<double> ticks;
  const bool few = 3 * decades <= maximum;
  for (double power = std::floor(logarithms.low / stride) * stride; power <= logarithms.high; power += stride)
    for (const double factor : {1.0, 2.0, 5.0}) {
      const double tick = power + std::log10(factor);
      const bool inside = tick >= logarithms.low - slack && tick <= logarithms.high + slack;
      if (inside && (few || factor == 1.0)) ticks.push_back(tick);
    }
  if (ticks.size() >= 2) return ticks;
  ticks.clear();
  for (const double tick :
       round_ticks({std::pow(10.0, logarithms.low), std::pow(10.0, logarithms.high)}, std::min(maximum, 4)))
    ticks.push_back(std::log10(tick));
  return ticks;
}

std::vector<std::string> log_tick_labels(const std::vector<double>& ticks) {
  std::vector<std::string> labels;
  for (int digits = 6; digits <= 16; ++digits) { // until no two are equal
    labels.clear();
    for (const double tick : ticks) labels.push_back(digits_of(std::pow(10.0, tick), digits));
    if (std::ranges::adjacent_find(labels) == labels.end()) break;
  }
  return labels;
}

Color viridis(double part) {
  // Eleven even steps of the map by van der Walt and Smith (2015), interpolated linearly.
  constexpr std::array<unsigned, 11> stops{0x440154, 0x482475, 0x414487, 0x355f8d, 0x2a788e, 0x21918c,
                                           0x22a884, 0x44bf70, 0x7ad151, 0xbddf26, 0xfde725};
  const double at = std::clamp(part, 0.0, 1.0) * 10;
  const std::size_t i = std::min<std::size_t>(static_cast<std::size_t>(at), 9);
  const auto channel = [&](unsigned shift) {
    const auto byte = [&](std::size_t stop) { return static_cast<double>((stops[stop] >> shift) & 255U); };
    return std::lerp(byte(i), byte(i + 1), at - static_cast<double>(i)) / 255;
  };
  return {channel(16), channel(8), channel(0)};
}

} // namespace riedel
