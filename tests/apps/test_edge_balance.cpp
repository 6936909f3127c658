/// Which schemes balance a pressure that points at the sides carry. Tractions are distributed by integrated hats, so
/// that those schemes do whose points sum the gradients of hats exactly.
#include "apps/biaxial/edge_balance.hpp"
#include "support/schemes.hpp"
#include "verification/biaxial.hpp"

#include <gtest/gtest.h>

namespace riedel::test {
namespace {

double imbalance(const std::string& scheme_name, int per_cell) {
  BiaxialCase values =
      biaxial_values({"scheme=" + scheme_name, "specimen.points_per_cell=" + std::to_string(per_cell)});
  values.loading.lateral = BiaxialCase::Lateral::points;
  return imbalance_at_start(values, catalogue());
}

/// Hats do, however they are averaged over a domain.
TEST(ImbalanceAtStart, VanishesUnderTheSchemesThatSaySoAndNoOthers) {
  for (const std::string& name : scheme_names()) {
    double maximum = 0.0;
    for (const int per_cell : {1, 2, 3}) maximum = std::max(maximum, imbalance(name, per_cell));
    if (traits(name).balances_pressure_on_points) {
      EXPECT_LT(maximum, 1e-12) << name;
    } else {
      EXPECT_GT(maximum, 0.01) << name << " balances it, and does not say so";
    }
  }
}

/// At a cell's centre a quadratic spline has the gradient of a hat. With cubic ones, half the force at an edge goes to
/// other nodes: 1/8, 3/4, 1/8 in place of 0, 1, 0; a little more in the rows next to a wall.
TEST(ImbalanceAtStart, VanishesUnderSplinesForSinglePointsUnderQuadraticOnesAlone) {
  EXPECT_LT(imbalance("bspline2", 1), 1e-12);
  EXPECT_GT(imbalance("bspline2", 2), 0.24);
  EXPECT_NEAR(imbalance("bspline3", 1), 0.28125, 1e-3);
  EXPECT_GT(imbalance("bspline3", 2), 0.24);
}

TEST(ImbalanceAtStart, VanishesUnderTheVirtualStressForEveryScheme) {
  for (const std::string& name : scheme_names())
    for (const char* per_cell : {"1", "2"}) {
      const BiaxialCase values =
          biaxial_values({"scheme=" + name, std::string("specimen.points_per_cell=") + per_cell});
      EXPECT_LT(imbalance_at_start(values, catalogue()), 1e-12) << name << ", " << per_cell;
    }
}

} // namespace
} // namespace riedel::test
