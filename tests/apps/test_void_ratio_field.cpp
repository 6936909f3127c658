/// Random void ratios, and a specimen that is rotated in its grid.
#include "apps/biaxial/band.hpp"
#include "apps/biaxial/patch.hpp"
#include "core/io/snapshot.hpp"
#include "core/setup/random_field.hpp"
#include "verification/biaxial.hpp"

#include <gmock/gmock.h>
#include <numbers>

namespace riedel::test {
namespace {

using testing::AllOf;
using testing::HasSubstr;

VoidRatioField with_field(int seed) {
  static BiaxialCase values = biaxial_values({"imperfection.deviation=0.01", "imperfection.correlation_length=5e-3"});
  values.imperfection.seed = seed;
  return random_field(values);
}

/// Over many fields at one place: mean, deviation, and the correlation with a place at a distance r, along x, y or
/// obliquely.
TEST(VoidRatioField, HasTheMeanDeviationAndCorrelationOfItsKeys) {
  constexpr int fields = 400;
  const double length = 5e-3;
  const Vec<2> x(0.013, 0.061), askew(-std::numbers::sqrt2 / 2, std::numbers::sqrt2 / 2);
  std::vector<VoidRatioField> all;
  for (int seed = 0; seed < fields; ++seed) all.push_back(with_field(seed));
  for (const Vec<2>& towards : {Vec<2>(1, 0), Vec<2>(0, 1), askew})
    for (const double r : {0.5 * length, length, 3.0 * length}) {
      double sum = 0.0, squares = 0.0, products = 0.0;
      for (const VoidRatioField& field : all) {
        const double a = field(x), b = field(x + r * towards);
        sum += a;
        squares += a * a;
        products += a * b;
      }
      EXPECT_NEAR(sum / fields, 0.0, 3.0 * 0.01 / std::sqrt(fields));
      EXPECT_NEAR(squares / fields / 1e-4, 1.0, 3.0 * std::sqrt(2.0 / fields));
      EXPECT_NEAR(products / squares, std::exp(-r * r / (length * length)), 0.15) << r;
    }
}

TEST(VoidRatioField, IsTheSameAtAPlaceOnEveryGrid) {
  const auto void_ratio_at = [](const std::string& cells, std::size_t point) {
    const Simulation<2> simulation = make_biaxial(
        biaxial_values({"imperfection.deviation=0.01", "imperfection.size=[0,0]", "grid.cells=" + cells}), catalogue());
    const Frame frame = snapshot(simulation);
    return std::pair(frame.position[3 * point], frame.field("void_ratio").values[point]);
  };
  // The middle of three fine cells is that of a coarse one.
  const auto [x, e] = void_ratio_at("[8,28]", 3);
  const auto [x_fine, e_fine] = void_ratio_at("[24,84]", 1 * 24 + 3 * 3 + 1);
  EXPECT_NEAR(x, x_fine, 1e-12);
  EXPECT_NEAR(e, e_fine, 1e-12);
  EXPECT_NE(e, 0.55);
}

/// The sixteenth digit may depend on the C library's cosine; which numbers were drawn does not.
TEST(VoidRatioField, DrawsTheSameNumbersEverywhere) {
  const VoidRatioField one = with_field(1), two = with_field(2);
  EXPECT_NEAR(one({0.01, 0.02}), 0.01097752865093217, 1e-12);
  EXPECT_NEAR(two({0.01, 0.02}), 0.01175041856017552, 1e-12);
}

std::string refusal(const std::vector<std::string>& settings) {
  try {
    (void)biaxial_values(settings);
  } catch (const InputError& error) { return error.what(); }
  return "";
}

TEST(VoidRatioField, IsRefusedWhereALawCouldNotFollow) {
  EXPECT_THAT(refusal({"imperfection.deviation=0.05"}),
              AllOf(HasSubstr("imperfection.deviation"), HasSubstr("the random field gives the point at ("),
                    HasSubstr("is out of range; the law allows (0.4959, 1.264]")));
  EXPECT_THAT(refusal({"imperfection.deviation=0.01", "material.model=linear_elastic", "nonlocal.length=0"}),
              HasSubstr("\"linear_elastic\" has no void ratio"));
  EXPECT_THAT(refusal({"imperfection.correlation_length=0"}), HasSubstr("imperfection.correlation_length"));
}

TEST(TurnedSpecimen, IsRefusedWhereTheGridMustStandUpright) {
  EXPECT_THAT(
      refusal({"specimen.rotation=10"}),
      AllOf(HasSubstr("loading.platen"), HasSubstr("\"moving_grid\" does not go with a specimen rotated by 10")));
  EXPECT_THAT(refusal({"specimen.rotation=10", "loading.platen=rigid_points", "loading.lateral=points"}),
              HasSubstr("take \"virtual_stress\""));
  EXPECT_THAT(refusal({"specimen.rotation=10", "loading.platen=rigid_points", "grid.dimensions=3"}),
              HasSubstr("grid.dimensions"));
}

/// An artificial band at 55°, reported in the specimen's own axes.
TEST(TurnedSpecimen, HasItsBandMeasuredInItsOwnAxes) {
  const BiaxialCase values = biaxial_values({"specimen.rotation=22.5", "loading.platen=rigid_points"});
  Frame frame = snapshot(make_biaxial(values, catalogue()));
  const Turn turn(values);
  const double slope = 55.0 * std::numbers::pi / 180.0;
  const auto field = [&](const char* name) { return std::ranges::find(frame.fields, std::string(name), &Field::name); };
  for (std::size_t p = 0; p < frame.points(); ++p) {
    const Vec<2> x = turn.to_specimen({frame.position[3 * p], frame.position[3 * p + 1]}) - Vec<2>(0.02, 0.1);
    const double across = std::cos(slope) * x[1] - std::sin(slope) * x[0];
    const double share = std::exp(-across * across / 1.2e-5);
    field("void_ratio")->values[p] += 0.25 * share;
    field("volume_ratio")->values[p] *= 1.0 + 0.25 * share / 1.55;
    field("polar_rotation")->values[p] += 20.0 * share;
    field("shear_strain")->values[p] = 0.01 + share;
  }
  const ShearBand band = measure_band(frame, values);
  ASSERT_TRUE(band.found);
  EXPECT_NEAR(band.inclination_deg, 55.0, 0.5);
  EXPECT_TRUE(band.rises_to_the_right);
}

} // namespace
} // namespace riedel::test
