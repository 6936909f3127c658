#include "core/analysis/band_line.hpp"

#include <numbers>

namespace riedel {

namespace {

struct Moments {
  Vec<2> mean = Vec<2>::Zero();       ///< [m]
  Mat<2> covariance = Mat<2>::Zero(); ///< [m²]
};

template <class Weight>
Moments moments(const BandSamples& samples, const Weight& weight) {
  Moments m;
  double total = 0.0;
  for (const BandSample& s : samples) {
    total += weight(s);
    m.mean += weight(s) * s.x;
  }
  m.mean /= total;
  for (const BandSample& s : samples) m.covariance += weight(s) / total * (s.x - m.mean) * (s.x - m.mean).transpose();
  return m;
}

/// The line, searched in steps of one degree, with the most dilation within two point spacings. Unlike the principal
/// axis, it is not drawn towards dilation elsewhere.
BandLine densest_strip(const BandSamples& band) {
  const Vec<2> mean = moments(band, dilation).mean;
  double reach = 0.0, area = 0.0;
  for (const BandSample& s : band) {
    reach = std::max(reach, (s.x - mean).norm());
    area += s.volume;
  }
  const double width = 2.0 * std::sqrt(area / static_cast<double>(band.size()));
  std::vector<double> strips(static_cast<std::size_t>(2.0 * reach / width) + 2);
  BandLine densest;
  double maximum = 0.0;
  for (int degree = -89; degree <= 90; ++degree) {
    const BandLine line{mean, degree * std::numbers::pi / 180.0};
    std::ranges::fill(strips, 0.0);
    for (const BandSample& s : band) strips[static_cast<std::size_t>((line.across(s) + reach) / width)] += dilation(s);
    for (std::size_t k = 0; k + 1 < strips.size(); ++k) {
      if (strips[k] + strips[k + 1] <= maximum) continue;
      maximum = strips[k] + strips[k + 1];
      densest = line;
      const double shift = static_cast<double>(k + 1) * width - reach;
      densest.centre += shift * Vec<2>(-std::sin(line.angle), std::cos(line.angle));
    }
  }
  const auto distance = [&](const BandSample& s) { return std::abs(densest.across(s)); };
  densest.spread = normal_deviation * quantile(band, 0.5, distance, dilation);
  return densest;
}

/// Takes the middle half of the dilation near the line as the straight part.
void bound_straight_part(BandLine& line, const BandSamples& band) {
  const BandSamples near = select(band, [&](const BandSample& s) { return line.near(s); });
  const auto along = [&](const BandSample& s) { return line.along(s); };
  line.begin = quantile(near, 0.25, along, dilation);
  line.end = quantile(near, 0.75, along, dilation);
}

/// The regression line through the points near the previous line. Weights fall smoothly to zero towards the ends, where
/// the edge of the specimen cuts the band obliquely or the band bends away.
BandLine regression(const BandLine& old, const BandSamples& band) {
  const double middle = 0.5 * (old.begin + old.end), reach = 0.8 * (old.end - old.begin);
  const auto weight = [&](const BandSample& s) {
    const double from_middle = (old.along(s) - middle) / reach;
    return old.near(s) ? dilation(s) * square(std::max(0.0, 1.0 - square(from_middle))) : 0.0;
  };
  const auto [mean, covariance] = moments(band, weight);
  const Vec<2> along(std::cos(old.angle), std::sin(old.angle)), across(-along[1], along[0]);
  const double slope = across.dot(covariance * along) / along.dot(covariance * along);
  const double angle = std::remainder(old.angle + std::atan(slope), std::numbers::pi);
  return {mean, angle, std::sqrt(across.dot(covariance * across))};
}

} // namespace

BandLine fit_line(const BandSamples& band) {
  BandLine line = densest_strip(band);
  bound_straight_part(line, band);
  for (int pass = 0; pass < 30; ++pass) {
    if (!(line.end > line.begin)) break;
    const double before = line.angle;
    line = regression(line, band);
    bound_straight_part(line, band);
    if (std::abs(line.angle - before) < 1e-6) break;
  }
  return line;
}

} // namespace riedel
