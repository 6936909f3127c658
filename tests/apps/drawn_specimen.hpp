/// A specimen with artificial bands, for tests of their measures.
#pragma once

#include "core/analysis/shear_band.hpp"
#include "core/base/types.hpp"

#include <cmath>
#include <functional>
#include <gmock/gmock.h>
#include <numbers>
#include <random>
#include <vector>

namespace riedel::test {

/// A specimen of 40 × 140 mm with one point in the middle of each cell, on which bands are drawn.
class Specimen {
public:
  Specimen(int columns, int rows, double e0 = 0.55) {
    const double h = 0.04 / columns, v = 0.14 / rows;
    for (int p = 0; p < columns * rows; ++p) {
      x_.push_back((p % columns + 0.5) * h);
      y_.push_back((p / columns + 0.5) * v);
    }
    volume_.assign(x_.size(), h * v);
    e0_.assign(x_.size(), e0);
    e_.assign(x_.size(), e0 + 0.012); // the whole specimen has dilated a little
    rotation_.assign(x_.size(), 0.0);
    shear_.assign(x_.size(), 0.03);
    rate_.assign(x_.size(), 0.1);
  }

  /// Adds a band through (x, y).
  /// @param angle_deg to the horizontal; positive: rises to the right   @param profile of the distance across [m], 1 at
  /// most
  Specimen& band(double angle_deg, double x, double y, double amplitude, const std::function<double(double)>& profile) {
    const double angle = angle_deg * std::numbers::pi / 180.0;
    for (std::size_t p = 0; p < x_.size(); ++p) {
      const double share = amplitude * profile(std::cos(angle) * (y_[p] - y) - std::sin(angle) * (x_[p] - x));
      e_[p] = std::max(e_[p], e0_[p] + 0.012 + share);
      rotation_[p] += std::copysign(2.0 * share, angle);
      shear_[p] += 4.0 * share;
      rate_[p] += 20.0 * share * share; // narrower than the dilation
    }
    return *this;
  }
  /// Removes all bands where `where(x, y)` holds.
  Specimen& wipe(const std::function<bool(double, double)>& where) {
    for (std::size_t p = 0; p < x_.size(); ++p) {
      if (!where(x_[p], y_[p])) continue;
      e_[p] = e0_[p] + 0.012;
      rotation_[p] = 0.0;
      shear_[p] = 0.03;
    }
    return *this;
  }
  /// Loose from the start, at the left edge at mid-height: 5 × 5 mm.
  Specimen& patch() {
    for (std::size_t p = 0; p < x_.size(); ++p)
      if (x_[p] < 0.005 && std::abs(y_[p] - 0.07) < 0.0025) {
        e0_[p] = 0.90;
        e_[p] = 0.89;
        rotation_[p] = 0.3;
        shear_[p] = 0.2;
      }
    return *this;
  }
  Specimen& noise(double of_void_ratio, double of_rotation) {
    std::mt19937 random(11);
    std::normal_distribution<double> normal;
    for (std::size_t p = 0; p < x_.size(); ++p) {
      e_[p] += of_void_ratio * normal(random);
      rotation_[p] += of_rotation * normal(random);
    }
    return *this;
  }
  /// Rotates the whole specimen a little.
  Specimen& tilt(double angle) {
    for (double& r : rotation_) r += angle;
    return *this;
  }
  Specimen& lose_point(std::size_t p) {
    e_[p] = std::nan("");
    return *this;
  }
  [[nodiscard]] ShearBand measure(const BandSettings& settings = {.length = 1.5e-3}) const {
    return measure_shear_band({x_, y_, volume_, e_, e0_, rotation_, shear_, rate_}, settings);
  }

  [[nodiscard]] ShearBand measure_by_shear() const {
    return measure_shear_band({x_, y_, volume_, {}, {}, rotation_, shear_, rate_}, {.length = 1.5e-3});
  }

private:
  std::vector<double> x_, y_, volume_, e_, e0_, rotation_, shear_, rate_;
};

inline std::function<double(double)> gaussian(double width) { ///< @param width at half maximum [m]
  return [=](double n) { return std::exp2(-4.0 * n * n / (width * width)); };
}
inline std::function<double(double)> box(double width) {
  return [=](double n) { return std::abs(n) <= 0.5 * width ? 1.0 : 0.0; };
}

struct Mesh {
  int columns, rows;
};
inline constexpr std::array<Mesh, 2> meshes = {{{24, 84}, {32, 112}}};

inline void expect_none(const ShearBand& band) {
  EXPECT_FALSE(band.found);
  EXPECT_EQ(band.kind, BandKind::none);
  for (const double figure :
       {band.inclination_deg, band.thickness_m, band.thickness_fwhm_m, band.thickness_rate_m, band.thickness_over_lc,
        band.threshold, band.void_ratio_inside, band.conjugate_ratio, band.straight_length_m})
    EXPECT_TRUE(std::isnan(figure)) << "zero would be a figure";
  EXPECT_EQ(band.doubt(), "");
}

} // namespace riedel::test
