#include "apps/shear_band.hpp"

#include "apps/band_line.hpp"

#include <numbers>
#include <utility>

namespace riedel {

namespace {

template <class Value>
double median(const BandSamples& samples, const Value& value) {
  return quantile(samples, 0.5, value, [](const BandSample& s) { return s.volume; });
}

BandSamples collect(const BandFields& f) {
  BandSamples samples;
  for (std::size_t p = 0; p < f.x.size(); ++p) {
    const BandSample s{{f.x[p], f.y[p]},
                       f.volume[p],
                       f.void_ratio[p],
                       f.void_ratio[p] - f.initial_void_ratio[p],
                       f.rotation[p],
                       f.shear[p],
                       f.rate.empty() ? 0.0 : f.rate[p]};
    if (std::isfinite(s.x.sum() + s.volume + s.rise + s.rotation + s.shear + s.rate) && s.volume > 0.0)
      samples.push_back(s);
  }
  const double rise = median(samples, [](const BandSample& s) { return s.rise; });
  const double rotation = median(samples, [](const BandSample& s) { return s.rotation; });
  const double rate = median(samples, [](const BandSample& s) { return s.rate; });
  for (BandSample& s : samples) {
    s.rise -= rise;
    s.rotation -= rotation;
    s.rate -= rate;
  }
  return samples;
}

/// What dilates by more than three times the usual deviation belongs to a band, to which by the sense of its rotation.
void assign_to_bands(BandSamples& samples) {
  const double deviation = median(samples, [](const BandSample& s) { return std::abs(s.rise); });
  for (BandSample& s : samples)
    if (s.rise > 3.0 * normal_deviation * deviation) s.band = (s.rotation > 0.0) - (s.rotation < 0.0);
}

double localisation_ratio(const BandSamples& samples) {
  std::vector<double> shear;
  for (const BandSample& s : samples) shear.push_back(s.shear);
  std::ranges::sort(shear);
  const std::size_t tenth = (shear.size() + 9) / 10;
  double top = 0.0;
  for (std::size_t k = shear.size() - tenth; k < shear.size(); ++k) top += shear[k] / static_cast<double>(tenth);
  return top > 0.0 ? top / std::max(shear[shear.size() / 2], 1e-6 * top) : 0.0;
}

double dilated_volume(const BandSamples& samples, int band) {
  double sum = 0.0;
  for (const BandSample& s : samples)
    if (s.band == band) sum += dilation(s);
  return sum;
}

struct Width {
  double peak = 0.0;              ///< largest mean at one distance from the line
  double left = 0.0, right = 0.0; ///< where it falls to half of that [m]
};

/// Mean of a quantity by distance from the line, in bins of half the spacing of points, and where it crosses half its
/// peak.
Width half_maximum(const BandSamples& beside, const BandLine& line, double spacing, double BandSample::*quantity) {
  const double bin = 0.5 * spacing, reach = 4.0 * line.spread + spacing;
  struct Mean {
    double volume = 0.0, at = 0.0, value = 0.0;
  };
  std::vector<Mean> profile(static_cast<std::size_t>(2.0 * reach / bin) + 1);
  for (const BandSample& s : beside) {
    if (std::abs(line.across(s)) >= reach) continue;
    Mean& mean = profile[static_cast<std::size_t>((line.across(s) + reach) / bin)];
    mean.volume += s.volume;
    mean.at += s.volume * line.across(s);
    mean.value += s.volume * s.*quantity;
  }
  std::erase_if(profile, [](const Mean& m) { return m.volume <= 0.0; });
  if (profile.empty()) return {};
  for (Mean& m : profile) m = {m.volume, m.at / m.volume, m.value / m.volume};

  const auto top = std::ranges::max_element(profile, {}, &Mean::value);
  const double half = 0.5 * top->value;
  const auto crossing = [&](auto inside, auto end) { // from the peak outwards
    for (auto outside = std::next(inside); outside != end; inside = outside++)
      if (outside->value < half)
        return std::lerp(inside->at, outside->at, (inside->value - half) / (inside->value - outside->value));
    return inside->at;
  };
  return {top->value, crossing(std::make_reverse_iterator(std::next(top)), profile.rend()),
          crossing(top, profile.end())};
}

/// Area and mean void ratio of the points that `keep` picks.
template <class Keep>
std::pair<double, double> area_and_void_ratio(const BandSamples& samples, const Keep& keep) {
  double area = 0.0, sum = 0.0;
  for (const BandSample& s : samples) {
    if (!keep(s)) continue;
    area += s.volume;
    sum += s.volume * s.e;
  }
  return {area, area > 0.0 ? sum / area : 0.0};
}

/// Is it long enough for a band, and does it dilate?
bool is_band(const BandSamples& samples, const ShearBand& band, const Width& width, const BandSettings& settings) {
  const auto [leftmost, rightmost] = std::ranges::minmax(samples, {}, [](const BandSample& s) { return s.x[0]; });
  return width.peak >= settings.least_dilation && band.straight_length_m > band.thickness_fwhm_m &&
         band.straight_length_m > 0.4 * (rightmost.x[0] - leftmost.x[0]);
}

/// Measures the band that turns as `side` says.
ShearBand measure(const BandSamples& samples, int side, const BandSettings& settings) {
  const BandSamples own = select(samples, [&](const BandSample& s) { return s.band == side; });
  ShearBand band;
  if (own.size() < 10) return band;
  const BandLine line = fit_line(own);
  if (!(line.end > line.begin)) return band; // no direction to speak of
  const BandSamples beside = select(samples, [&](const BandSample& s) { return s.band != -side && line.beside(s); });
  const double spacing = std::sqrt(area_and_void_ratio(samples, [](const BandSample&) { return true; }).first /
                                   static_cast<double>(samples.size()));
  const Width width = half_maximum(beside, line, spacing, &BandSample::rise);
  const Width of_rate = half_maximum(beside, line, spacing, &BandSample::rate);

  band.inclination_deg = std::abs(line.angle) * 180.0 / std::numbers::pi;
  band.rises_to_the_right = line.angle > 0.0;
  band.straight_length_m = line.end - line.begin;
  band.thickness_fwhm_m = width.right - width.left;
  if (of_rate.peak > 0.0) band.thickness_rate_m = of_rate.right - of_rate.left;
  band.found = is_band(samples, band, width, settings);

  const double outside = median(samples, [](const BandSample& s) { return s.e; });
  band.threshold = outside < settings.threshold ? settings.threshold : outside + 0.5 * width.peak;
  const auto loose = [&](const BandSample& s) { return s.band == side && line.near(s) && s.e >= band.threshold; };
  band.thickness_m = area_and_void_ratio(beside, loose).first / band.straight_length_m;
  if (settings.length > 0.0) band.thickness_over_lc = band.thickness_m / settings.length;

  const double middle = 0.5 * (width.left + width.right), quarter = 0.25 * band.thickness_fwhm_m;
  const auto inside = [&](const BandSample& s) {
    return s.band == side && std::abs(line.across(s) - middle) <= quarter;
  };
  band.void_ratio_inside = area_and_void_ratio(beside, inside).second;
  return band;
}

} // namespace

const char* name_of(BandKind kind) {
  constexpr std::array names = {"none", "single", "x"};
  return names[static_cast<std::size_t>(kind)];
}

ShearBand measure_shear_band(const BandFields& fields, const BandSettings& settings) {
  BandSamples samples = collect(fields);
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
