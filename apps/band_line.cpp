#include "apps/band_line.hpp"

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

/// Mean and principal axis of V (e − e0).
BandLine principal_axis(const BandSamples& band) {
  const auto [mean, covariance] = moments(band, dilation);
  const double difference = covariance(0, 0) - covariance(1, 1), shear = 2.0 * covariance(0, 1);
  const double least = 0.5 * (covariance.trace() - std::hypot(difference, shear));
  return {mean, 0.5 * std::atan2(shear, difference), std::sqrt(std::max(0.0, least))};
}

/// The middle half of what lies near the line.
void bound_straight_part(BandLine& line, const BandSamples& band) {
  const BandSamples near = select(band, [&](const BandSample& s) { return line.near(s); });
  const auto along = [&](const BandSample& s) { return line.along(s); };
  line.begin = quantile(near, 0.25, along, dilation);
  line.end = quantile(near, 0.75, along, dilation);
}

/// The line of regression through what lies near the old one, with a weight that falls to zero smoothly towards the
/// ends: they are cut askew by the edge of the specimen, or bend away.
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
  BandLine line = principal_axis(band);
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
