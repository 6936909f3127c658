/// The lateral pressure as a virtual stress: a body under the surrounding pressure is at rest, whatever its shape, and
/// a specimen that is compressed keeps that lateral pressure.
#include "support/schemes.hpp"
#include "verification/biaxial.hpp"

#include <cstdio>
#include <gtest/gtest.h>
#include <omp.h>

namespace riedel::test {
namespace {

constexpr double pressure = 50e3;

/// σ = −p I.
void fill_with_pressure(Points<2>& points, double p) {
  for (const int c : {0, 1, 2}) points.stress.fill(c, -p);
}

bool in_disc(const Vec<2>& x) { return (x - Vec<2>(0.5, 0.5)).norm() < 0.41; }
bool in_parallelogram(const Vec<2>& x) {
  return x[1] > 0.13 && x[1] < 0.82 && x[0] > 0.05 + 0.4 * x[1] && x[0] < 0.47 + 0.4 * x[1];
}

/// An elastic body inside the confining pressure, with `inside` pressure in its points.
Simulation<2> surrounded(const std::string& scheme_name, bool (*shape)(const Vec<2>&), double inside) {
  State<2> state = elastic_state<2>({12, 12}, 1.0 / 12, 2, 4, shape);
  fill_with_pressure(state.bodies[0].points, inside);
  Model<2> model = model_with<2>(scheme_name);
  model.confining_pressure = pressure;
  return {std::move(model), std::move(state)};
}

double fastest(const Simulation<2>& simulation) {
  const Points<2>& points = simulation.state().bodies[0].points;
  double speed = 0.0;
  for (Index p = 0; p < points.size(); ++p) speed = std::max(speed, points.velocity_of(p).norm());
  return speed;
}

class VirtualStressTest : public testing::TestWithParam<std::string> {
protected:
  void SetUp() override { omp_set_num_threads(1); } // too small to share
};

TEST_P(VirtualStressTest, HoldsABodyOfAnyShapeAtRestWithTheExactPressureInEveryPoint) {
  for (const auto shape : {in_disc, in_parallelogram}) {
    Simulation<2> simulation = surrounded(GetParam(), shape, pressure);
    for (int i = 0; i < 200; ++i) simulation.step();
    EXPECT_LT(fastest(simulation), 1e-12);
    const Points<2>& points = simulation.state().bodies[0].points;
    for (Index p = 0; p < points.size(); ++p) {
      for (const int c : {0, 1, 2}) EXPECT_NEAR(points.stress[c][p], -pressure, 1e-10 * pressure) << "point " << p;
      EXPECT_NEAR(points.stress[3][p], 0.0, 1e-10 * pressure);
    }
  }
}

/// Under p, an elastic disc shrinks until its mean stress is −p (plane strain, small strain).
TEST_P(VirtualStressTest, PressesABodyThatStartsWithoutStressUntilItBearsThePressure) {
  Simulation<2> simulation = surrounded(GetParam(), in_disc, 0.0);
  simulation.step();
  EXPECT_GT(fastest(simulation), 0.01);
  Points<2>& points = simulation.state().bodies[0].points;
  double before = 0.0;
  for (int i = 0; i < 1500; ++i) { // stopped at each crest of kinetic energy
    simulation.step();
    const double now = simulation.energies().kinetic;
    if (now < before)
      for (const int a : {0, 1}) points.velocity.fill(a, 0.0);
    before = now < before ? 0.0 : now;
  }
  double mean = 0.0, volume = 0.0;
  for (Index p = 0; p < points.size(); ++p) {
    mean += 0.5 * points.volume[0][p] * (points.stress[0][p] + points.stress[1][p]);
    volume += points.volume[0][p];
  }
  std::printf("%s: mean in-plane stress over −p: %.6f\n", GetParam().c_str(), mean / volume / -pressure);
  EXPECT_NEAR(mean / volume, -pressure, 1e-3 * pressure);
}

TEST_P(VirtualStressTest, LetsABodyOfHigherPressureExpand) {
  Simulation<2> simulation = surrounded(GetParam(), in_parallelogram, 1.1 * pressure);
  double before = 0.0, after = 0.0;
  const Points<2>& points = simulation.state().bodies[0].points;
  for (Index p = 0; p < points.size(); ++p) before += points.volume[0][p];
  for (int i = 0; i < 10; ++i) simulation.step();
  for (Index p = 0; p < points.size(); ++p) after += points.volume[0][p];
  EXPECT_GT(after, before);
}

/// A homogeneous elastic specimen; the platen starts so slowly that waves are negligible.
TEST_P(VirtualStressTest, KeepsThePressureSidewaysInEveryPointOfASpecimenThatIsCompressed) {
  const BiaxialCase values = biaxial_values(
      {"scheme=" + GetParam(), "material.model=linear_elastic", "loading.gravity=0.0", "grid.cells=[8, 12]",
       "specimen.width=0.08", "specimen.height=0.12", "loading.ramp_time=0.05", "loading.speed=0.02", "time.flip=0.9"});
  Simulation<2> simulation = make_biaxial(values, catalogue());
  while (simulation.state().time < 0.06) simulation.step(); // 0.6 % of vertical strain
  const Points<2>& points = simulation.state().bodies[0].points;
  double farthest = 0.0, axial = 0.0;
  for (Index p = 0; p < points.size(); ++p) {
    farthest = std::max(farthest, std::abs(points.stress[0][p] / -pressure - 1.0));
    axial += points.stress[1][p] / points.size();
  }
  std::printf("%s: axial stress %.1f Pa, σ_xx off −p by at most %.2e p\n", GetParam().c_str(), axial, farthest);
  EXPECT_LT(axial, -2.0 * pressure);
  // Under very wide functions more of the mass is at the edges, and waves last longer.
  EXPECT_LT(farthest, is_very_wide(GetParam()) ? 5e-3 : 3e-3);
}

INSTANTIATE_TEST_SUITE_P(EveryScheme, VirtualStressTest, testing::ValuesIn(scheme_names()),
                         [](const auto& tested) { return tested.param; });

} // namespace
} // namespace riedel::test
