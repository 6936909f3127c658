#include "core/analysis/stress_quality.hpp"

#include "core/base/parameters.hpp"

#include <cmath>

namespace riedel {

namespace {

/// Deviation of a quantity at one point from the mean of its neighbourhood.
double rest(std::span<const double> values, const QualityFields& f, std::size_t p, const QualitySettings& s) {
  double weight = 0.0, sum = 0.0;
  for (std::size_t q = 0; q < f.x.size(); ++q) {
    const double r = std::hypot(f.x[q] - f.x[p], f.y[q] - f.y[p]);
    if (r > s.core) continue;
    const double w = std::exp(-r * r / (s.smoothing * s.smoothing));
    weight += w;
    sum += w * values[q];
  }
  return values[p] - sum / weight;
}

/// Points near the band's line, except near its ends.
std::vector<std::size_t> core_of(const QualityFields& f, const BandLine& line, double distance) {
  const double fifth = 0.2 * (line.end - line.begin);
  std::vector<std::size_t> core;
  for (std::size_t p = 0; p < f.x.size(); ++p) {
    const Vec<2> at(f.x[p], f.y[p]);
    const double along = line.along(at);
    if (std::abs(line.across(at)) <= distance && line.begin + fifth <= along && along <= line.end - fifth)
      core.push_back(p);
  }
  return core;
}

} // namespace

std::string StressQuality::doubt() const {
  std::string text;
  if (pressure_scatter > doubtful_scatter)
    text = "the pressures of neighbouring points in the band differ by " + short_text(100.0 * pressure_scatter, 2) +
           " % (rms about the local mean)";
  if (without_stress > 0)
    text += (text.empty() ? "" : ", and ") + std::to_string(without_stress) + " of " + std::to_string(core_points) +
            " points in its core carry no stress";
  return text;
}

StressQuality measure_stress_quality(const QualityFields& f, const ShearBand& band, const QualitySettings& settings) {
  StressQuality quality;
  if (band.kind == BandKind::none) return quality;
  const std::vector<std::size_t> core = core_of(f, band.line, settings.core);
  quality.core_points = core.size();
  if (core.empty()) return quality;
  const double count = static_cast<double>(core.size());
  const auto scatter = [&](std::span<const double> values) {
    double sum = 0.0, squares = 0.0;
    for (const std::size_t p : core) {
      sum += values[p];
      const double off = rest(values, f, p, settings);
      squares += off * off;
    }
    return std::pair(sum / count, std::sqrt(squares / count));
  };
  const auto [pressure, of_pressure] = scatter(f.pressure);
  quality.pressure_scatter = of_pressure / std::abs(pressure);
  if (!f.void_ratio.empty()) quality.void_ratio_scatter = scatter(f.void_ratio).second;
  const auto [rate, of_rate] = scatter(f.rate);
  if (rate > 0.0) quality.rate_scatter = of_rate / rate;
  for (const std::size_t p : core) quality.without_stress += f.pressure[p] < settings.min_pressure;
  return quality;
}

} // namespace riedel
