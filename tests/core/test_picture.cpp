#include "core/base/error.hpp"
#include "core/draw/domain_raster.hpp"
#include "core/draw/picture.hpp"
#include "core/png_pixels.hpp"

#include <cmath>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace riedel {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

constexpr unsigned purple = 0x440154, yellow = 0xfde725, missing = 0xbfbfbf;

/// columns × rows square domains of 1 mm; the field is 0 in the left half and 1 in the right.
/// @param shear slope by which each domain, but not its position, is skewed  @param size of a domain over its share
Frame halves(int columns, int rows, double shear = 0, double size = 1) {
  Frame frame;
  Field field{"void_ratio", 1, "-", {}};
  for (int j = 0; j < rows; ++j)
    for (int i = 0; i < columns; ++i) {
      const double x = (i + 0.5) * 1e-3, y = (j + 0.5) * 1e-3, h = 0.5e-3 * size;
      frame.position.insert(frame.position.end(), {x, y, 0});
      for (const auto& [a, b] : {std::pair{-h, -h}, {h, -h}, {h, h}, {-h, h}})
        frame.corners.insert(frame.corners.end(), {x + a + shear * b, y + b, 0});
      field.values.push_back(2 * i < columns ? 0 : 1);
    }
  frame.fields.push_back(field);
  return frame;
}

PictureOptions options() {
  PictureOptions o;
  o.field = "void_ratio";
  o.label = "void ratio e [-]";
  o.title = "title";
  o.width = 800;
  o.height = 600;
  return o;
}

class Picture : public testing::Test {
protected:
  fs::path path = fs::path(testing::TempDir()) /
                  (std::string("riedel_") + testing::UnitTest::GetInstance()->current_test_info()->name() + ".png");
  void TearDown() override { fs::remove(path); }
};

TEST_F(Picture, ShowsLowValuesPurpleAndHighValuesYellow) {
  write_field_picture(path, halves(20, 40), options());
  PngPixels png(path);
  EXPECT_EQ(png.height(), 600);
  EXPECT_LT(png.width(), 600) << "a slender specimen needs no wide picture";
  const int middle = png.height() / 2;
  EXPECT_GT(png.count_in_row(middle, purple), 80);
  EXPECT_NEAR(png.count_in_row(middle, purple), png.count_in_row(middle, yellow), 2);
  int x = 0;
  while (png.at(x, middle) != purple) ++x;
  EXPECT_EQ(png.at(x + 2 * png.count_in_row(middle, purple) - 3, middle), yellow) << "high values are at the right";
}

TEST_F(Picture, TakesItsColoursFromTheGivenRange) {
  PictureOptions o = options();
  o.range = Interval{-1, 0}; // now everything is at the upper end, or beyond
  write_field_picture(path, halves(20, 40), o);
  PngPixels png(path);
  EXPECT_EQ(png.count_in_row(png.height() / 2, purple), 0);
  EXPECT_GT(png.count_in_row(png.height() / 2, yellow), 160);
}

TEST_F(Picture, SharesOneRangeAmongPanels) {
  Frame low = halves(20, 40), high = halves(20, 40);
  for (double& value : low.fields[0].values) value = 3;
  for (double& value : high.fields[0].values) value = 5;
  PictureOptions o = options();
  write_field_pictures(path, {{&low, "low", ""}, {&high, "high", ""}}, o);
  PngPixels png(path);
  EXPECT_LE(png.width(), 800);
  const int middle = png.height() / 2, low_pixels = png.count_in_row(middle, purple);
  EXPECT_GT(low_pixels, 100);
  EXPECT_EQ(low_pixels, png.count_in_row(middle, yellow));
}

TEST_F(Picture, ShowsValuesThatAreNotFiniteInGrey) {
  Frame frame = halves(20, 40);
  for (double& value : frame.fields[0].values)
    if (value == 1) value = std::nan("");
  write_field_picture(path, frame, options());
  PngPixels png(path);
  EXPECT_GT(png.count_in_row(png.height() / 2, missing), 80);
}

TEST_F(Picture, RefusesWhatItCannotDraw) {
  PictureOptions o = options();
  o.field = "voidratio";
  try {
    write_field_picture(path, halves(2, 2), o);
    FAIL();
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), HasSubstr("voidratio"));
    EXPECT_THAT(error.what(), HasSubstr("there are: void_ratio"));
  }
  o = options();
  o.component = 1;
  EXPECT_THROW(write_field_picture(path, halves(2, 2), o), InputError);
  Frame solid = halves(2, 2);
  solid.dimension = 3;
  solid.corners.clear();
  EXPECT_THROW(write_field_picture(path, solid, options()), InputError);
  EXPECT_THROW(write_field_picture("/dev/null/a.png", halves(2, 2), options()), RunError);
}

TEST(DomainRaster, GivesEachCellToTheDomainThatCoversIt) {
  const DomainRaster raster = rasterise_domains(halves(3, 2), {0, 2e-3, 3e-3, 0}, 0.1e-3);
  ASSERT_EQ(raster.width, 30);
  ASSERT_EQ(raster.height, 20);
  for (int y = 0; y < 20; ++y)
    for (int x = 0; x < 30; ++x) EXPECT_EQ(raster.at(x, y), x / 10 + (y < 10 ? 3 : 0)) << x << ", " << y;
}

TEST(DomainRaster, LeavesNoGapsInsideASpecimenWhoseDomainsDoNotFit) {
  for (const Frame& frame : {halves(8, 8, 0, 0.6), halves(8, 8, 0.8), halves(8, 8, 0, 1.7)}) {
    const DomainRaster raster = rasterise_domains(frame, {-2e-3, 10e-3, 10e-3, -2e-3}, 0.05e-3);
    for (int y = 60; y < 180; ++y)
      for (int x = 60; x < 180; ++x) {
        const int column = (x - 40) / 20, row = 7 - (y - 40) / 20; // of the point that belongs there
        const int owner = raster.at(x, y);
        ASSERT_GE(owner, 0) << x << ", " << y;
        ASSERT_LE(std::abs(owner % 8 - column), 1);
        ASSERT_LE(std::abs(owner / 8 - row), 1);
      }
    EXPECT_EQ(raster.at(2, 2), -1) << "outside the specimen";
  }
}

} // namespace
} // namespace riedel
