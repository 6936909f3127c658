/// The paper's own boundaries, a platen of rigid points and the lateral pressure on a layer of points, against the
/// default ones on a coarse grid: at rest at the start, and the same mobilised angle up to u/h0 = 0.5 %.
#include "apps/biaxial/edge_balance.hpp"
#include "support/schemes.hpp"
#include "verification/biaxial.hpp"

#include <cstdio>
#include <gtest/gtest.h>
#include <omp.h>

namespace riedel::test {
namespace {

/// Mobilised angles at u/h0 = 0.1, 0.2 … 0.5 %, each the mean over 0.1 %.
using Angles = std::array<double, 5>;

Angles compress(const std::string& scheme_name, const std::string& platen, const std::string& lateral,
                const std::string& rotation = "0") {
  const BiaxialCase values =
      coarse_values({"scheme=" + scheme_name, "loading.platen=" + platen, "loading.lateral=" + lateral,
                     "nonlocal.length=0.0", "loading.speed=0.2", "specimen.rotation=" + rotation});
  Simulation<2> simulation = make_biaxial(values, catalogue());
  const auto speed = ramped(values.loading.speed, values.loading.ramp_time);
  Angles angles{};
  double u = 0.0;
  for (std::size_t i = 0; i < angles.size(); ++i) {
    double impulse = 0.0, time = 0.0;
    while (u < 0.001 * static_cast<double>(i + 1) * values.specimen.height) {
      simulation.step();
      const double dt = simulation.time_step();
      u += speed(simulation.state().time) * dt;
      impulse += platen_force(simulation, values) * dt;
      time += dt;
    }
    angles[i] = mobilised_angle(impulse / time, values);
  }
  std::printf("%-7s %-12s %-14s", scheme_name.c_str(), platen.c_str(), lateral.c_str());
  for (const double angle : angles) std::printf(" %6.2f", angle);
  std::printf(" deg\n");
  return angles;
}

double farthest(const Angles& a, const Angles& b) {
  double maximum = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) maximum = std::max(maximum, std::abs(a[i] - b[i]));
  return maximum;
}

class PlatenTest : public testing::TestWithParam<std::string> {
protected:
  void SetUp() override { omp_set_num_threads(1); } // too small to share
  /// Whether the pressure on points, which is distributed by hats, balances the scheme's forces of a stress at an edge.
  static bool loads_edges_by_hats() {
    BiaxialCase values = coarse_values({"scheme=" + GetParam()});
    values.loading.lateral = BiaxialCase::Lateral::points;
    return imbalance_at_start(values, catalogue()) < 0.01;
  }
};

TEST_P(PlatenTest, OfRigidPointsGivesTheAngleOfTheMovingGrid) {
  const Angles usual = compress(GetParam(), "moving_grid", "virtual_stress");
  EXPECT_GT(usual.back(), 30.0);
  EXPECT_LT(farthest(compress(GetParam(), "rigid_points", "virtual_stress"), usual), 1.5);
}

TEST_P(PlatenTest, OfASpecimenTurnedInTheGridGivesTheAngleOfTheUprightOne) {
  const SchemeTraits promised = traits(GetParam());
  if (!promised.continuous_gradients)
    GTEST_SKIP() << "points without extent, one for a cell, leave cells empty where their rows lie askew";
  // Neither domains of points nor second order: 4.7 deg under ddmp, 3.4 deg under lme.
  const bool by_nodes = promised.domain == PointDomain::none && promised.order_across_cells < 2;
  const Angles usual = compress(GetParam(), "moving_grid", "virtual_stress");
  EXPECT_LT(farthest(compress(GetParam(), "rigid_points", "virtual_stress", "30"), usual), by_nodes ? 6.0 : 2.0);
}

TEST_P(PlatenTest, LeavesATurnedSpecimenWithoutWeightAtRest) {
  Simulation<2> simulation =
      make_biaxial(coarse_values({"scheme=" + GetParam(), "loading.platen=rigid_points", "specimen.rotation=30",
                                  "loading.gravity=0", "loading.speed=1e-12"}),
                   catalogue());
  for (int i = 0; i < 3; ++i) simulation.step();
  const Points<2>& points = simulation.state().bodies.front().points;
  for (Index p = 0; p < points.size(); ++p) ASSERT_LT(points.velocity_of(p).norm(), 1e-10) << p;
}

TEST_P(PlatenTest, WithPressureOnALayerOfPointsGivesTheAngleOfTheVirtualStress) {
  if (!loads_edges_by_hats())
    GTEST_SKIP() << "the scheme does not start in equilibrium with hats at the edge, and is refused";
  const Angles usual = compress(GetParam(), "moving_grid", "virtual_stress");
  EXPECT_LT(farthest(compress(GetParam(), "moving_grid", "points"), usual), 2.0);
  EXPECT_LT(farthest(compress(GetParam(), "rigid_points", "points"), usual), 3.0);
}

/// Hardly driven at all, a specimen that starts in equilibrium does not move; without the whole pressure its surface
/// would move with p/(ρ c) = 0.15 m/s.
TEST_P(PlatenTest, StartsInEquilibriumWithEveryKindOfBoundary) {
  for (const std::string platen : {"moving_grid", "rigid_points"})
    for (const std::string lateral : {"virtual_stress", "points"}) {
      if (lateral == "points" && !loads_edges_by_hats()) continue;
      const BiaxialCase values =
          coarse_values({"scheme=" + GetParam(), "loading.platen=" + platen, "loading.lateral=" + lateral,
                         "nonlocal.length=0.0", "loading.speed=1e-6", "loading.ramp_time=1.0"});
      Simulation<2> simulation = make_biaxial(values, catalogue());
      double fastest = 0.0;
      for (int i = 0; i < 200; ++i) {
        simulation.step();
        const Points<2>& points = simulation.state().bodies[0].points;
        for (Index p = 0; p < points.size(); ++p) fastest = std::max(fastest, points.velocity_of(p).norm());
      }
      const double angle = mobilised_angle(platen_force(simulation, values), values);
      std::printf("%-7s %-12s %-14s at rest: fastest point %.1e m/s, angle %.3f deg\n", GetParam().c_str(),
                  platen.c_str(), lateral.c_str(), fastest, angle);
      EXPECT_LT(fastest, 3e-3) << platen << ", " << lateral;
      EXPECT_NEAR(angle, 0.0, 0.5) << platen << ", " << lateral;
    }
}

INSTANTIATE_TEST_SUITE_P(EveryScheme, PlatenTest, testing::ValuesIn(scheme_names()),
                         [](const auto& tested) { return tested.param; });

} // namespace
} // namespace riedel::test
