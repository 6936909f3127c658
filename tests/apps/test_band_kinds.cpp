/// The limit between a band and a diffuse zone, which of its measures exist, and when they are doubtful.
#include "apps/drawn_specimen.hpp"

namespace riedel::test {
namespace {

TEST(ShearBandKind, HasNoThicknessInALengthThatThereIsNot) {
  const ShearBand band = Specimen(24, 84).band(56.0, 0.02, 0.1, 0.27, gaussian(7.5e-3)).measure({.length = 0.0});
  EXPECT_TRUE(band.found);
  EXPECT_GT(band.thickness_m, 0.0);
  EXPECT_TRUE(std::isnan(band.thickness_over_lc));
}

TEST(ShearBandKind, HasNoThicknessByAVoidRatioThatNoPointReaches) {
  const ShearBand band = Specimen(24, 84).band(56.0, 0.02, 0.1, 0.10, gaussian(7.5e-3)).measure();
  ASSERT_TRUE(band.found);
  EXPECT_NEAR(band.thickness_fwhm_m, 7.5e-3, 0.05 * 7.5e-3);
  EXPECT_TRUE(std::isnan(band.thickness_m)); // 0.66 at most
  EXPECT_TRUE(std::isnan(band.thickness_over_lc));
}

/// Zones of the same dilation and increasing width: a slender one is a band, any other is diffuse, never none.
TEST(ShearBandKind, IsDiffuseWhereItIsAsWideAsItIsLong) {
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

/// Decreasing strength or length: between a band and none there is a diffuse zone.
TEST(ShearBandKind, IsDiffuseBeforeItIsNone) {
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

TEST(ShearBandKind, IsDoubtedWhereItsWidthsDifferThreefold) {
  const ShearBand sharp = Specimen(24, 84).band(56.0, 0.02, 0.07, 0.27, gaussian(7.5e-3)).measure();
  EXPECT_EQ(sharp.doubt(), "");
  const ShearBand blunt = // barely above 0.70 in the middle
      Specimen(24, 84).band(56.0, 0.02, 0.07, 0.142, gaussian(16e-3)).measure();
  ASSERT_NE(blunt.kind, BandKind::none);
  EXPECT_GT(blunt.thickness_fwhm_m, 3.0 * blunt.thickness_m);
  EXPECT_THAT(blunt.doubt(), testing::HasSubstr("differ by a factor of "));
}

TEST(ShearBandKind, IsDoubtedWhereASecondOneIsHalfAsStrong) {
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

/// A law without a void ratio: the band is measured by the shear strain.
TEST(ShearBandKind, IsMeasuredByShearWhereThereIsNoVoidRatio) {
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

} // namespace
} // namespace riedel::test
