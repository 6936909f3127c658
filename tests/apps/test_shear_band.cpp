#include "apps/shear_band.hpp"

#include "core/base/types.hpp"

#include <cmath>
#include <functional>
#include <gmock/gmock.h>
#include <numbers>
#include <random>
#include <vector>

namespace riedel {
namespace {

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
  /// Turns the whole specimen a little.
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

std::function<double(double)> gaussian(double width) { ///< @param width at half maximum [m]
  return [=](double n) { return std::exp2(-4.0 * n * n / (width * width)); };
}
std::function<double(double)> box(double width) {
  return [=](double n) { return std::abs(n) <= 0.5 * width ? 1.0 : 0.0; };
}

struct Mesh {
  int columns, rows;
};
constexpr std::array<Mesh, 2> meshes = {{{24, 84}, {32, 112}}};

TEST(ShearBand, IsFoundWithItsInclinationAndWidth) {
  for (const Mesh mesh : meshes)
    for (const double angle : {50.0, 53.0, 55.0, 56.8, 60.0, 62.0})
      for (const double sign : {1.0, -1.0})
        for (const double width : {6e-3, 7.5e-3, 10e-3}) {
          SCOPED_TRACE(testing::Message() << mesh.rows << " rows, " << sign * angle << " deg, " << width << " m");
          const ShearBand band =
              Specimen(mesh.columns, mesh.rows).band(sign * angle, 0.021, 0.09, 0.27, gaussian(width)).measure();
          ASSERT_TRUE(band.found);
          EXPECT_EQ(band.kind, BandKind::single);
          EXPECT_NEAR(band.inclination_deg, angle, 0.5);
          EXPECT_EQ(band.rises_to_the_right, sign > 0);
          EXPECT_NEAR(band.thickness_fwhm_m, width, 0.05 * width);
          const double above = width * std::sqrt(std::log2(0.27 / (0.70 - 0.562))); // e ≥ 0.70 on this width
          EXPECT_NEAR(band.thickness_m, above, 0.10 * above);
          EXPECT_DOUBLE_EQ(band.thickness_over_lc, band.thickness_m / 1.5e-3);
          EXPECT_NEAR(band.void_ratio_inside, 0.562 + 0.27 * 0.945, 0.01);
          EXPECT_GT(band.localisation_ratio, 5.0);
        }
}

TEST(ShearBand, OfEvenDilationHasTheWidthOfItsBox) {
  for (const Mesh mesh : meshes)
    for (const double angle : {50.0, -55.0, 58.0, -62.0}) {
      SCOPED_TRACE(testing::Message() << mesh.rows << " rows, " << angle << " deg");
      const ShearBand band = Specimen(mesh.columns, mesh.rows).band(angle, 0.02, 0.05, 0.25, box(8e-3)).measure();
      ASSERT_TRUE(band.found);
      EXPECT_NEAR(band.inclination_deg, std::abs(angle), 0.5);
      EXPECT_NEAR(band.thickness_fwhm_m, 8e-3, 0.05 * 8e-3);
      EXPECT_NEAR(band.thickness_m, 8e-3, 0.10 * 8e-3);
      EXPECT_NEAR(band.void_ratio_inside, 0.812, 1e-6);
    }
}

TEST(ShearBand, IsMeasuredInNoise) {
  for (const Mesh mesh : meshes) {
    const ShearBand band = Specimen(mesh.columns, mesh.rows)
                               .band(-56.0, 0.018, 0.095, 0.27, gaussian(7.5e-3))
                               .patch()
                               .noise(0.015, 0.05)
                               .tilt(0.03)
                               .measure();
    ASSERT_TRUE(band.found);
    EXPECT_EQ(band.kind, BandKind::single);
    EXPECT_NEAR(band.inclination_deg, 56.0, 0.5);
    EXPECT_NEAR(band.thickness_fwhm_m, 7.5e-3, 0.05 * 7.5e-3);
    EXPECT_LT(band.conjugate_ratio, 0.02); // neither noise nor patch is a band
  }
}

TEST(ShearBand, CrossingAnEqualOneIsAnX) {
  for (const Mesh mesh : meshes) {
    const ShearBand band = Specimen(mesh.columns, mesh.rows)
                               .band(56.0, 0.02, 0.07, 0.27, gaussian(7.5e-3))
                               .band(-56.0, 0.02, 0.07, 0.27, gaussian(7.5e-3))
                               .tilt(0.8) // of the whole specimen: tells nothing
                               .measure();
    ASSERT_TRUE(band.found);
    EXPECT_EQ(band.kind, BandKind::x);
    EXPECT_GT(band.conjugate_ratio, 0.9);
    EXPECT_NEAR(band.inclination_deg, 56.0, 1.0);
    EXPECT_NEAR(band.thickness_fwhm_m, 7.5e-3, 0.10 * 7.5e-3);
  }
}

TEST(ShearBand, IsTheStrongerOfTwo) {
  for (const Mesh mesh : meshes) {
    const ShearBand band = Specimen(mesh.columns, mesh.rows)
                               .band(57.0, 0.02, 0.10, 0.27, gaussian(7.5e-3))
                               .band(-52.0, 0.02, 0.045, 0.09, gaussian(7.5e-3))
                               .measure();
    ASSERT_TRUE(band.found);
    EXPECT_EQ(band.kind, BandKind::single);
    EXPECT_TRUE(band.rises_to_the_right);
    EXPECT_NEAR(band.conjugate_ratio, 0.295, 0.04); // a third, and the weaker one is shorter
    EXPECT_NEAR(band.inclination_deg, 57.0, 0.5);
    EXPECT_NEAR(band.thickness_fwhm_m, 7.5e-3, 0.05 * 7.5e-3);
  }
}

TEST(ShearBand, IsMeasuredWhereItIsStraight) {
  for (const Mesh mesh : meshes) { // it reaches the top and comes back as a short band of the other sense
    Specimen specimen(mesh.columns, mesh.rows);
    specimen.band(-56.0, 0.035, 0.14, 0.20, gaussian(7.5e-3)).wipe([](double x, double) { return x < 0.035; });
    specimen.band(56.0, 0.0, 0.088, 0.27, gaussian(7.5e-3));
    const ShearBand band = specimen.measure();
    ASSERT_TRUE(band.found);
    EXPECT_EQ(band.kind, BandKind::single);
    EXPECT_NEAR(band.inclination_deg, 56.0, 0.5);
    EXPECT_NEAR(band.thickness_fwhm_m, 7.5e-3, 0.05 * 7.5e-3);
  }
}

TEST(ShearBand, IsNotTurnedByWhatDilatesElsewhere) {
  for (const Mesh mesh : meshes) { // a spot at the left edge that turns the same way
    Specimen specimen(mesh.columns, mesh.rows);
    specimen.band(5.0, 0.0, 0.125, 0.25, gaussian(10e-3)).wipe([](double x, double) { return x > 0.010; });
    const ShearBand band = specimen.band(57.0, 0.02, 0.10, 0.27, gaussian(7.5e-3)).measure();
    ASSERT_TRUE(band.found);
    EXPECT_NEAR(band.inclination_deg, 57.0, 0.5);
    EXPECT_NEAR(band.thickness_fwhm_m, 7.5e-3, 0.05 * 7.5e-3);
  }
}

TEST(ShearBand, OfAnInitiallyLooserSpecimenCountsFromHalfItsDilation) {
  const ShearBand band = Specimen(24, 84, 0.75).band(51.0, 0.02, 0.08, 0.06, box(9e-3)).measure();
  ASSERT_TRUE(band.found);
  EXPECT_NEAR(band.threshold, 0.75 + 0.012 + 0.03, 1e-6);
  EXPECT_NEAR(band.thickness_m, 9e-3, 0.10 * 9e-3);
  EXPECT_NEAR(band.inclination_deg, 51.0, 0.5);
}

TEST(ShearBand, IsMeasuredThoughAPointIsLost) {
  const Specimen whole = Specimen(24, 84).band(55.0, 0.02, 0.08, 0.27, gaussian(7.5e-3));
  const ShearBand band = Specimen(whole).lose_point(3).measure();
  EXPECT_TRUE(band.found);
  EXPECT_NEAR(band.inclination_deg, whole.measure().inclination_deg, 0.01);
}

void expect_none(const ShearBand& band) {
  EXPECT_FALSE(band.found);
  EXPECT_EQ(band.kind, BandKind::none);
  for (const double figure :
       {band.inclination_deg, band.thickness_m, band.thickness_fwhm_m, band.thickness_rate_m, band.thickness_over_lc,
        band.threshold, band.void_ratio_inside, band.conjugate_ratio, band.straight_length_m})
    EXPECT_TRUE(std::isnan(figure)) << "zero would be a figure";
  EXPECT_EQ(band.doubt(), "");
}

TEST(ShearBand, IsNotInAHomogeneousSpecimen) {
  expect_none(Specimen(24, 84).measure());
  expect_none(Specimen(32, 112).noise(0.01, 0.05).measure());
  expect_none(Specimen(24, 84, 0.90).measure());
}

TEST(ShearBand, IsNotThePatch) {
  expect_none(Specimen(24, 84).patch().measure());
  expect_none(Specimen(32, 112).patch().noise(0.002, 0.01).measure());
}

TEST(ShearBand, IsNotAShortOne) {
  for (const Mesh mesh : meshes) // dilation and shear around the patch alone, as at the very beginning
    expect_none(Specimen(mesh.columns, mesh.rows)
                    .band(56.0, 0.0, 0.07, 0.27, gaussian(7.5e-3))
                    .wipe([](double x, double) { return x > 0.010; })
                    .measure({.least_ratio = 0.0}));
}

TEST(ShearBand, IsNotWhereNothingDilates) {
  expect_none(Specimen(24, 84).band(56.0, 0.02, 0.07, 0.005, gaussian(7.5e-3)).measure({.least_ratio = 0.0}));
}

TEST(ShearBand, IsNotAHeapOfPointsInOnePlace) {
  const std::vector<double> place(50, 0.01), one(50, 1.0), e0(50, 0.55);
  std::vector<double> e(50, 0.55), rotation(50, 0.0);
  std::fill_n(e.begin(), 20, 0.8);
  std::fill_n(rotation.begin(), 20, 0.1);
  expect_none(measure_shear_band({place, place, one, e, e0, rotation, one}, {.least_ratio = 0.0}));
}

TEST(ShearBand, HasAWidthByItsRateThatNeedNotBeThatOfItsDilation) {
  for (const Mesh mesh : meshes)
    for (const double width : {6e-3, 7.5e-3, 10e-3}) {
      const ShearBand band = Specimen(mesh.columns, mesh.rows).band(56.0, 0.02, 0.1, 0.27, gaussian(width)).measure();
      EXPECT_NEAR(band.thickness_rate_m, width / std::numbers::sqrt2, 0.05 * width) << width;
    }
}

TEST(ShearBand, HasNoThicknessInALengthThatThereIsNot) {
  const ShearBand band = Specimen(24, 84).band(56.0, 0.02, 0.1, 0.27, gaussian(7.5e-3)).measure({.length = 0.0});
  EXPECT_TRUE(band.found);
  EXPECT_GT(band.thickness_m, 0.0);
  EXPECT_TRUE(std::isnan(band.thickness_over_lc));
}

TEST(ShearBand, HasNoThicknessByAVoidRatioThatNoPointReaches) {
  const ShearBand band = Specimen(24, 84).band(56.0, 0.02, 0.1, 0.10, gaussian(7.5e-3)).measure();
  ASSERT_TRUE(band.found);
  EXPECT_NEAR(band.thickness_fwhm_m, 7.5e-3, 0.05 * 7.5e-3);
  EXPECT_TRUE(std::isnan(band.thickness_m)); // 0.66 at most
  EXPECT_TRUE(std::isnan(band.thickness_over_lc));
}

/// Wider and wider zones of the same dilation: what is slender is a band, and what is not is diffuse, never nothing.
TEST(ShearBand, IsDiffuseWhereItIsAsWideAsItIsLong) {
  BandKind last = BandKind::single;
  std::vector<BandKind> kinds;
  for (double width = 6e-3; width < 45e-3; width *= 1.02) {
    const ShearBand band = Specimen(12, 42).band(57.0, 0.02, 0.075, 0.2, gaussian(width)).measure();
    EXPECT_NE(band.kind, BandKind::none) << width;
    EXPECT_EQ(band.found, band.kind != BandKind::diffuse);
    EXPECT_GT(band.thickness_fwhm_m, 0.0) << "its figures are told";
    if (kinds.empty() || band.kind != last) kinds.push_back(last = band.kind);
  }
  EXPECT_EQ(kinds, (std::vector{BandKind::single, BandKind::diffuse})) << "it changes its kind once";
}

/// Weaker and weaker, or shorter and shorter: between a band and none lies what is diffuse.
TEST(ShearBand, IsDiffuseBeforeItIsNone) {
  const auto kinds_of = [](const auto& specimen) {
    std::vector<BandKind> kinds;
    for (double share = 1.0; share > 0.02; share *= 0.97)
      if (const BandKind kind = specimen(share).kind; kinds.empty() || kinds.back() != kind) kinds.push_back(kind);
    return kinds;
  };
  const std::vector fading{BandKind::single, BandKind::diffuse, BandKind::none};
  EXPECT_EQ(kinds_of([](double share) {
              return Specimen(24, 84).band(56.0, 0.02, 0.07, 0.27 * share, gaussian(7.5e-3)).measure();
            }),
            fading);
  EXPECT_EQ(kinds_of([](double share) {
              return Specimen(24, 84)
                  .band(56.0, 0.0, 0.07, 0.27, gaussian(5e-3))
                  .wipe([=](double x, double) { return x > 0.040 * share; })
                  .measure();
            }),
            fading);
}

TEST(ShearBand, IsDoubtedWhereItsWidthsDifferThreefold) {
  const ShearBand sharp = Specimen(24, 84).band(56.0, 0.02, 0.07, 0.27, gaussian(7.5e-3)).measure();
  EXPECT_EQ(sharp.doubt(), "");
  const ShearBand blunt = // barely above 0.70 in the middle
      Specimen(24, 84).band(56.0, 0.02, 0.07, 0.142, gaussian(16e-3)).measure();
  ASSERT_NE(blunt.kind, BandKind::none);
  EXPECT_GT(blunt.thickness_fwhm_m, 3.0 * blunt.thickness_m);
  EXPECT_THAT(blunt.doubt(), testing::HasSubstr("differ by a factor of "));
}

TEST(ShearBand, IsDoubtedWhereASecondOneIsHalfAsStrong) {
  const auto with = [](double amplitude) {
    return Specimen(24, 84)
        .band(56.0, 0.02, 0.07, 0.27, gaussian(7.5e-3))
        .band(-56.0, 0.02, 0.07, amplitude, gaussian(7.5e-3))
        .measure();
  };
  EXPECT_THAT(with(0.15).doubt(), testing::HasSubstr("\"single\" or \"x\" is a matter of chance"));
  EXPECT_EQ(with(0.02).doubt(), "");
  EXPECT_EQ(with(0.27).doubt(), "");
}

/// A law without a void ratio: its shear strain tells.
TEST(ShearBand, IsMeasuredByShearWhereThereIsNoVoidRatio) {
  for (const Mesh mesh : meshes) {
    const ShearBand band =
        Specimen(mesh.columns, mesh.rows).band(-54.0, 0.02, 0.08, 0.1, gaussian(8e-3)).measure_by_shear();
    ASSERT_TRUE(band.found);
    EXPECT_TRUE(band.by_shear);
    EXPECT_NEAR(band.inclination_deg, 54.0, 0.5);
    EXPECT_NEAR(band.thickness_fwhm_m, 8e-3, 0.05 * 8e-3);
    EXPECT_TRUE(std::isnan(band.thickness_m) && std::isnan(band.thickness_over_lc) &&
                std::isnan(band.void_ratio_inside));
  }
  expect_none(Specimen(24, 84).noise(0.01, 0.05).measure_by_shear());
}

TEST(ShearBand, IsNotInAnEmptySpecimen) { expect_none(measure_shear_band({})); }

TEST(ShearBand, HasANameForEachKind) {
  EXPECT_STREQ(name_of(BandKind::none), "none");
  EXPECT_STREQ(name_of(BandKind::diffuse), "diffuse");
  EXPECT_STREQ(name_of(BandKind::single), "single");
  EXPECT_STREQ(name_of(BandKind::x), "x");
}

} // namespace
} // namespace riedel
