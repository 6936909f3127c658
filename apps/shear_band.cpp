#include "apps/shear_band.hpp"

#include "core/base/types.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

namespace riedel {

namespace {

/// One point as the measurement sees it.
struct Sample {
  Vec<2> x;        ///< [m]
  double volume;   ///< [m²]
  double e;        ///< void ratio [-]
  double rise;     ///< e − e0, less the specimen's median [-]
  double rotation; ///< less the specimen's median [rad]
  double shear;    ///< [-] or [1/s]
  int band = 0;    ///< +1, −1: belongs to the band that turns anticlockwise, clockwise; 0: to none
};
using Samples = std::vector<Sample>;

/// The value below which `share` of the weight lies.
template <class Value, class Weight>
double quantile(Samples samples, double share, const Value& value, const Weight& weight) {
  if (samples.empty()) return 0.0;
  std::ranges::sort(samples, {}, value);
  double total = 0.0, sum = 0.0;
  for (const Sample& s : samples) total += weight(s);
  for (const Sample& s : samples)
    if ((sum += weight(s)) >= share * total) return value(s);
  return value(samples.back());
}

template <class Value>
double median(const Samples& samples, const Value& value) {
  return quantile(samples, 0.5, value, [](const Sample& s) { return s.volume; });
}

Samples collect(const BandFields& f) {
  Samples samples;
  for (std::size_t p = 0; p < f.x.size(); ++p) {
    const Sample s{{f.x[p], f.y[p]}, f.volume[p], f.void_ratio[p], f.void_ratio[p] - f.initial_void_ratio[p],
                   f.rotation[p],    f.shear[p]};
    if (std::isfinite(s.x.sum() + s.volume + s.rise + s.rotation + s.shear)) samples.push_back(s);
  }
  const double rise = median(samples, [](const Sample& s) { return s.rise; });
  const double rotation = median(samples, [](const Sample& s) { return s.rotation; });
  for (Sample& s : samples) {
    s.rise -= rise;
    s.rotation -= rotation;
  }
  return samples;
}

/// What dilates by more than three times the usual deviation belongs to a band, to which by the sense of its rotation.
void assign_to_bands(Samples& samples) {
  constexpr double sigma_over_deviation = 1.4826; // standard over median absolute deviation of a normal distribution
  const double deviation = median(samples, [](const Sample& s) { return std::abs(s.rise); });
  for (Sample& s : samples)
    if (s.rise > 3.0 * sigma_over_deviation * deviation) s.band = (s.rotation > 0.0) - (s.rotation < 0.0);
}

double localisation_ratio(const Samples& samples) {
  std::vector<double> shear;
  for (const Sample& s : samples) shear.push_back(s.shear);
  std::ranges::sort(shear);
  const std::size_t tenth = (shear.size() + 9) / 10;
  double top = 0.0;
  for (std::size_t k = shear.size() - tenth; k < shear.size(); ++k) top += shear[k] / static_cast<double>(tenth);
  return top > 0.0 ? top / std::max(shear[shear.size() / 2], 1e-6 * top) : 0.0;
}

double dilated_volume(const Samples& samples, int band) {
  double sum = 0.0;
  for (const Sample& s : samples)
    if (s.band == band) sum += s.volume * s.rise;
  return sum;
}

/// The middle of a band and how far it was followed.
struct Line {
  Vec<2> centre = Vec<2>::Zero(); ///< [m]
  double angle = 0.0;             ///< to the horizontal, −π/2 to π/2 [rad]
  double spread = 0.0;            ///< standard deviation across [m]
  double begin = 0.0, end = 0.0;  ///< of the straight part, along the line from the centre [m]

  [[nodiscard]] double along(const Sample& s) const {
    return std::cos(angle) * (s.x - centre)[0] + std::sin(angle) * (s.x - centre)[1];
  }
  [[nodiscard]] double across(const Sample& s) const {
    return std::cos(angle) * (s.x - centre)[1] - std::sin(angle) * (s.x - centre)[0];
  }
  [[nodiscard]] bool near(const Sample& s) const { return std::abs(across(s)) <= 3.0 * spread; }
  [[nodiscard]] bool beside(const Sample& s) const { return begin <= along(s) && along(s) <= end; }
};

double dilation(const Sample& s) { return s.volume * s.rise; }

/// Mean and principal axes of Σ V (e − e0).
Line principal_axis(const Samples& samples) {
  Line line;
  double weight = 0.0;
  for (const Sample& s : samples) {
    weight += dilation(s);
    line.centre += dilation(s) * s.x;
  }
  line.centre /= weight;
  Mat<2> covariance = Mat<2>::Zero();
  for (const Sample& s : samples)
    covariance += dilation(s) / weight * (s.x - line.centre) * (s.x - line.centre).transpose();
  const double difference = covariance(0, 0) - covariance(1, 1), shear = 2.0 * covariance(0, 1);
  line.angle = 0.5 * std::atan2(shear, difference);
  line.spread = std::sqrt(std::max(0.0, 0.5 * (covariance.trace() - std::hypot(difference, shear))));
  return line;
}

template <class Keep>
Samples select(const Samples& samples, const Keep& keep) {
  Samples kept;
  std::ranges::copy_if(samples, std::back_inserter(kept), keep);
  return kept;
}

/// The middle half of what lies near the line.
void bound_straight_part(Line& line, const Samples& band) {
  const Samples near = select(band, [&](const Sample& s) { return line.near(s); });
  const auto along = [&](const Sample& s) { return line.along(s); };
  line.begin = quantile(near, 0.25, along, dilation);
  line.end = quantile(near, 0.75, along, dilation);
}

/// Fitted again and again to what lies near the line and beside its straight part: free of the ends, which the edge of
/// the specimen cuts askew, and of parts that bend away.
Line fit_line(const Samples& band) {
  Line line = principal_axis(band);
  for (int pass = 0; pass < 30; ++pass) {
    bound_straight_part(line, band);
    const Samples straight = select(band, [&](const Sample& s) { return line.near(s) && line.beside(s); });
    if (straight.size() < 3) break;
    const Line better = principal_axis(straight);
    const double turn = std::abs(better.angle - line.angle);
    line = better;
    if (turn < 1e-6) break;
  }
  bound_straight_part(line, band);
  return line;
}

struct Width {
  double peak = 0.0;              ///< largest mean of e − e0 at one distance from the line [-]
  double left = 0.0, right = 0.0; ///< where it falls to half of that [m]
};

/// Mean of e − e0 by distance from the line, in bins of half the spacing of points, and where it crosses half its peak.
Width half_maximum(const Samples& beside, const Line& line, double spacing) {
  const double bin = 0.5 * spacing, reach = 4.0 * line.spread + spacing;
  struct Mean {
    double volume = 0.0, at = 0.0, rise = 0.0;
  };
  std::vector<Mean> profile(static_cast<std::size_t>(2.0 * reach / bin) + 1);
  for (const Sample& s : beside) {
    if (std::abs(line.across(s)) >= reach) continue;
    Mean& mean = profile[static_cast<std::size_t>((line.across(s) + reach) / bin)];
    mean.volume += s.volume;
    mean.at += s.volume * line.across(s);
    mean.rise += s.volume * s.rise;
  }
  std::erase_if(profile, [](const Mean& m) { return m.volume <= 0.0; });
  if (profile.empty()) return {};
  for (Mean& m : profile) m = {m.volume, m.at / m.volume, m.rise / m.volume};

  const auto top = std::ranges::max_element(profile, {}, &Mean::rise);
  const double half = 0.5 * top->rise;
  const auto crossing = [&](auto inside, auto end) { // from the peak outwards
    for (auto outside = std::next(inside); outside != end; inside = outside++)
      if (outside->rise < half)
        return std::lerp(inside->at, outside->at, (inside->rise - half) / (inside->rise - outside->rise));
    return inside->at;
  };
  return {top->rise, crossing(std::make_reverse_iterator(std::next(top)), profile.rend()),
          crossing(top, profile.end())};
}

/// Area and mean void ratio of the points that `keep` picks.
template <class Keep>
std::pair<double, double> area_and_void_ratio(const Samples& samples, const Keep& keep) {
  double area = 0.0, sum = 0.0;
  for (const Sample& s : samples) {
    if (!keep(s)) continue;
    area += s.volume;
    sum += s.volume * s.e;
  }
  return {area, area > 0.0 ? sum / area : 0.0};
}

/// Is it long enough for a band, and does it dilate?
bool is_band(const Samples& samples, const ShearBand& band, const Width& width, const BandSettings& settings) {
  const auto [leftmost, rightmost] = std::ranges::minmax(samples, {}, [](const Sample& s) { return s.x[0]; });
  return width.peak >= settings.least_dilation && band.straight_length_m > band.thickness_fwhm_m &&
         band.straight_length_m > 0.4 * (rightmost.x[0] - leftmost.x[0]);
}

/// Measures the band that turns as `side` says.
ShearBand measure(const Samples& samples, int side, const BandSettings& settings) {
  const Samples own = select(samples, [&](const Sample& s) { return s.band == side; });
  ShearBand band;
  if (own.size() < 10) return band;
  const Line line = fit_line(own);
  const Samples beside = select(samples, [&](const Sample& s) { return s.band != -side && line.beside(s); });
  const double spacing = std::sqrt(area_and_void_ratio(samples, [](const Sample&) { return true; }).first /
                                   static_cast<double>(samples.size()));
  const Width width = half_maximum(beside, line, spacing);

  band.inclination_deg = std::abs(line.angle) * 180.0 / std::numbers::pi;
  band.rises_to_the_right = line.angle > 0.0;
  band.straight_length_m = line.end - line.begin;
  band.thickness_fwhm_m = width.right - width.left;
  band.found = is_band(samples, band, width, settings);

  const double outside = median(samples, [](const Sample& s) { return s.e; });
  band.threshold = outside < settings.threshold ? settings.threshold : outside + 0.5 * width.peak;
  const auto loose = [&](const Sample& s) { return s.band == side && line.near(s) && s.e >= band.threshold; };
  band.thickness_m = area_and_void_ratio(beside, loose).first / band.straight_length_m;
  if (settings.length > 0.0) band.thickness_over_lc = band.thickness_m / settings.length;

  const double middle = 0.5 * (width.left + width.right), quarter = 0.25 * band.thickness_fwhm_m;
  const auto inside = [&](const Sample& s) { return s.band == side && std::abs(line.across(s) - middle) <= quarter; };
  band.void_ratio_inside = area_and_void_ratio(beside, inside).second;
  return band;
}

} // namespace

const char* name_of(BandKind kind) {
  constexpr std::array names = {"none", "single", "x"};
  return names[static_cast<std::size_t>(kind)];
}

ShearBand measure_shear_band(const BandFields& fields, const BandSettings& settings) {
  Samples samples = collect(fields);
  assign_to_bands(samples);
  const double right = dilated_volume(samples, 1), left = dilated_volume(samples, -1);
  const double ratio = localisation_ratio(samples);

  ShearBand band;
  if (ratio >= settings.least_ratio) band = measure(samples, right >= left ? 1 : -1, settings);
  if (!band.found) band = {};
  band.localisation_ratio = ratio;
  if (!band.found) return band;
  band.conjugate_ratio = std::min(left, right) / std::max(left, right);
  band.kind = band.conjugate_ratio > 0.5 ? BandKind::x : BandKind::single;
  return band;
}

} // namespace riedel
