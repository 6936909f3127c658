#include "core/analysis/shear_band.hpp"

#include "core/analysis/band_line.hpp"
#include "core/base/parameters.hpp"

#include <numbers>
#include <utility>

namespace riedel {

namespace {

constexpr double even_ratio = 0.5; ///< conjugate ratio above which two bands are an "x"

template <class Value>
double median(const BandSamples& samples, const Value& value) {
  return quantile(samples, 0.5, value, [](const BandSample& s) { return s.volume; });
}

BandSamples collect(const BandFields& f) {
  BandSamples samples;
  for (std::size_t p = 0; p < f.x.size(); ++p) {
    const BandSample s{{f.x[p], f.y[p]},
                       f.volume[p],
                       f.by_shear() ? no_figure : f.void_ratio[p],
                       f.by_shear() ? f.shear[p] : f.void_ratio[p] - f.initial_void_ratio[p],
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

/// A point belongs to a band if it dilates by more than three times the usual deviation; the sense of its rotation
/// decides which. If a zone is so wide that it dominates the deviation, half of the largest dilation is the limit.
void assign_to_bands(BandSamples& samples) {
  const auto volume = [](const BandSample& s) { return s.volume; };
  const double deviation = median(samples, [](const BandSample& s) { return std::abs(s.rise); });
  const double maximum = quantile(
      samples, 0.99, [](const BandSample& s) { return s.rise; }, volume);
  const double minimum = std::min(3.0 * normal_deviation * deviation, 0.5 * maximum);
  for (BandSample& s : samples)
    if (s.rise > minimum) s.band = (s.rotation > 0.0) - (s.rotation < 0.0);
}

double localisation_ratio(const BandSamples& samples) {
  std::vector<double> shear;
  for (const BandSample& s : samples) shear.push_back(s.shear);
  std::ranges::sort(shear);
  const std::size_t tenth = (shear.size() + 9) / 10;
  double top = 0.0;
  for (std::size_t k = shear.size() - tenth; k < shear.size(); ++k) top += shear[k] / static_cast<double>(tenth);
  return top > 0.0 ? top / std::max(shear[shear.size() / 2], 1e-6 * top) : no_figure;
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

/// Area and mean void ratio of the points selected by `keep`.
template <class Keep>
std::pair<double, double> area_and_void_ratio(const BandSamples& samples, const Keep& keep) {
  double area = 0.0, sum = 0.0;
  for (const BandSample& s : samples) {
    if (!keep(s)) continue;
    area += s.volume;
    sum += s.volume * s.e;
  }
  return {area, area > 0.0 ? sum / area : no_figure};
}

/// Whether a measure exceeds its minimum, or comes so close that another run of the same test may differ.
enum class Answer { no, nearly, yes };
Answer exceeds(double measure, double minimum) {
  constexpr double near = 0.8;
  return measure >= minimum ? Answer::yes : measure >= near * minimum ? Answer::nearly : Answer::no;
}

/// Classifies localised strain: a band if the zone is slender; diffuse if it is not, or if it is almost too weak or too
/// short to count.
BandKind kind_of(const BandSamples& samples, const ShearBand& band, const Width& width, const BandSettings& settings) {
  const auto [leftmost, rightmost] = std::ranges::minmax(samples, {}, [](const BandSample& s) { return s.x[0]; });
  const Answer gathered =
      std::min({exceeds(band.localisation_ratio, settings.min_ratio), exceeds(width.peak, settings.min_dilation),
                exceeds(band.straight_length_m, 0.4 * (rightmost.x[0] - leftmost.x[0]))});
  if (gathered == Answer::no) return BandKind::none;
  const bool slender = band.straight_length_m >= settings.min_slenderness * band.thickness_fwhm_m;
  return gathered == Answer::yes && slender ? BandKind::single : BandKind::diffuse;
}

/// Measures the band whose sense of rotation is `side`.
ShearBand measure(const BandSamples& samples, int side, double ratio, const BandSettings& settings) {
  const BandSamples own = select(samples, [&](const BandSample& s) { return s.band == side; });
  ShearBand band{.localisation_ratio = ratio};
  if (own.size() < 10) return band;
  const BandLine line = fit_line(own);
  if (!(line.end > line.begin)) return band; // no clear direction
  const BandSamples beside = select(samples, [&](const BandSample& s) { return s.band != -side && line.beside(s); });
  const double spacing = std::sqrt(area_and_void_ratio(samples, [](const BandSample&) { return true; }).first /
                                   static_cast<double>(samples.size()));
  const Width width = half_maximum(beside, line, spacing, &BandSample::rise);
  const Width of_rate = half_maximum(beside, line, spacing, &BandSample::rate);

  band.line = line;
  band.inclination_deg = std::abs(line.angle) * 180.0 / std::numbers::pi;
  band.rises_to_the_right = line.angle > 0.0;
  band.straight_length_m = line.end - line.begin;
  band.thickness_fwhm_m = width.right - width.left;
  if (of_rate.peak > 0.0) band.thickness_rate_m = of_rate.right - of_rate.left;
  band.kind = kind_of(samples, band, width, settings);

  const double outside = median(samples, [](const BandSample& s) { return s.e; });
  band.threshold = outside < settings.threshold ? settings.threshold : outside + 0.5 * width.peak;
  const auto loose = [&](const BandSample& s) { return s.band == side && line.near(s) && s.e >= band.threshold; };
  if (const double area = area_and_void_ratio(beside, loose).first; area > 0.0)
    band.thickness_m = area / band.straight_length_m;
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
  constexpr std::array names = {"none", "diffuse", "single", "x"};
  return names[static_cast<std::size_t>(kind)];
}

std::string ShearBand::doubt() const {
  constexpr double far = 3.0;
  std::string text;
  const auto add = [&](const std::string& more) { text += (text.empty() ? "" : "; ") + more; };
  if (kind == BandKind::none) return text;
  const double minimum = std::fmin(thickness_m, std::fmin(thickness_fwhm_m, thickness_rate_m)),
               maximum = std::fmax(thickness_m, std::fmax(thickness_fwhm_m, thickness_rate_m));
  if (maximum >= far * minimum)
    add("its widths by void ratio, at half maximum and by rate differ by a factor of " +
        short_text(maximum / minimum, 2) + ", and none of them can be trusted");
  if (found && std::abs(conjugate_ratio - even_ratio) <= 0.1)
    add("the weaker of the two bands has " + short_text(conjugate_ratio, 2) +
        " of the stronger one: \"single\" or \"x\" is a matter of chance");
  return text;
}

ShearBand measure_shear_band(const BandFields& fields, const BandSettings& given) {
  BandSettings settings = given;
  if (fields.by_shear()) settings.min_dilation = 0.0;
  BandSamples samples = collect(fields);
  assign_to_bands(samples);
  const double right = dilated_volume(samples, 1), left = dilated_volume(samples, -1);
  const double ratio = localisation_ratio(samples);

  ShearBand band;
  if (exceeds(ratio, settings.min_ratio) != Answer::no)
    band = measure(samples, right >= left ? 1 : -1, ratio, settings);
  if (band.kind == BandKind::none) band = {.localisation_ratio = ratio};
  band.by_shear = fields.by_shear();
  if (band.kind == BandKind::none) return band;
  band.conjugate_ratio = std::min(left, right) / std::max(left, right);
  band.found = band.kind == BandKind::single;
  if (band.found && band.conjugate_ratio > even_ratio) band.kind = BandKind::x;
  return band;
}

} // namespace riedel
