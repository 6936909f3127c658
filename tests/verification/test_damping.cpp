/// The default damping rate of a biaxial test.
#include "transfers/flip.hpp"
#include "verification/biaxial.hpp"

#include <gtest/gtest.h>

namespace riedel::test {
namespace {

TEST(Damping, GrowsInverselyWithTheSpeedOfASlowTest) {
  const auto damping = [](const std::string& speed) {
    const Simulation<2> simulation =
        make_biaxial<2>(biaxial_values({"loading.speed=" + speed, "grid.cells=[4,14]"}), catalogue());
    return dynamic_cast<const Flip<2>&>(*simulation.model().transfer).blend().damping.value();
  };
  EXPECT_EQ(damping("0.1"), damping("0.5"));
  EXPECT_EQ(damping("0.1"), damping("0.05"));
  EXPECT_GT(damping("0.025"), 1.5 * damping("0.05"));
  EXPECT_NEAR(damping("0.0125"), 2.0 * damping("0.025"), 1e-9 * damping("0.0125"));
}

} // namespace
} // namespace riedel::test
