#include "apps/drawn_specimen.hpp"

namespace riedel::test {
namespace {

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
                               .tilt(0.8) // of the whole specimen: no sign of a band
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
  for (const Mesh mesh : meshes) { // a spot at the left edge that rotates the same way
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
                    .measure({.min_ratio = 0.0}));
}

TEST(ShearBand, IsNotWhereNothingDilates) {
  expect_none(Specimen(24, 84).band(56.0, 0.02, 0.07, 0.005, gaussian(7.5e-3)).measure({.min_ratio = 0.0}));
}

TEST(ShearBand, IsNotAHeapOfPointsInOnePlace) {
  const std::vector<double> place(50, 0.01), one(50, 1.0), e0(50, 0.55);
  std::vector<double> e(50, 0.55), rotation(50, 0.0);
  std::fill_n(e.begin(), 20, 0.8);
  std::fill_n(rotation.begin(), 20, 0.1);
  expect_none(measure_shear_band({place, place, one, e, e0, rotation, one}, {.min_ratio = 0.0}));
}

TEST(ShearBand, HasAWidthByItsRateThatNeedNotBeThatOfItsDilation) {
  for (const Mesh mesh : meshes)
    for (const double width : {6e-3, 7.5e-3, 10e-3}) {
      const ShearBand band = Specimen(mesh.columns, mesh.rows).band(56.0, 0.02, 0.1, 0.27, gaussian(width)).measure();
      EXPECT_NEAR(band.thickness_rate_m, width / std::numbers::sqrt2, 0.05 * width) << width;
    }
}

TEST(ShearBand, IsNotInAnEmptySpecimen) { expect_none(measure_shear_band({})); }

TEST(ShearBand, HasANameForEachKind) {
  EXPECT_STREQ(name_of(BandKind::none), "none");
  EXPECT_STREQ(name_of(BandKind::diffuse), "diffuse");
  EXPECT_STREQ(name_of(BandKind::single), "single");
  EXPECT_STREQ(name_of(BandKind::x), "x");
}

} // namespace
} // namespace riedel::test
