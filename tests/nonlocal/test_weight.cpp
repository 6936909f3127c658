#include "nonlocal/kit/weight.hpp"

#include <gtest/gtest.h>

namespace riedel {
namespace {

TEST(GaussWeight, FallsToOneOverEAtTheCharacteristicLength) {
  const GaussWeight weight(1.5e-3);
  EXPECT_DOUBLE_EQ(weight(0.0), 1.0);
  EXPECT_NEAR(weight(square(1.5e-3)), std::exp(-1.0), 1e-15);
  EXPECT_NEAR(weight(square(3e-3)), std::exp(-4.0), 1e-15);
}

TEST(GaussWeight, IsExactlyZeroBeyondThreeCharacteristicLengths) {
  const GaussWeight weight(2.0);
  EXPECT_GT(weight(36.0), 1.2e-4);
  EXPECT_EQ(weight(std::nextafter(36.0, 37.0)), 0.0);
  EXPECT_EQ(weight(1e300), 0.0);
}

TEST(GaussWeight, IsTheSameForAPackAsForItsNumbers) {
  const GaussWeight weight(0.7);
  std::array<double, pack_size> squared{}, omega{};
  for (int k = 0; k < 50; ++k) {
    for (int lane = 0; lane < pack_size; ++lane) squared[lane] = 0.0123 * (k * pack_size + lane);
    weight(Pack::load(squared.data())).store(omega.data());
    for (int lane = 0; lane < pack_size; ++lane) EXPECT_NEAR(omega[lane], weight(squared[lane]), 1e-15);
  }
}

} // namespace
} // namespace riedel
