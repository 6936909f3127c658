/// The biaxial specimen as a slab one cell thick, in three dimensions between smooth walls: the plane strain curve.
#include "verification/biaxial.hpp"

#include <cstdio>
#include <gtest/gtest.h>
#include <omp.h>

namespace riedel::test {
namespace {

/// Mobilised angle by u/h0, each the mean over 0.1 % of it [deg].
template <int Dim>
std::vector<double> curve(std::vector<std::string> settings) {
  settings.push_back("grid.dimensions=" + std::to_string(Dim));
  const BiaxialCase values = biaxial_values(settings);
  omp_set_num_threads(1); // too small to share
  Simulation<Dim> simulation = make_biaxial<Dim>(values, catalogue());
  const auto speed = ramped(values.loading.speed, values.loading.ramp_time);
  const double height = values.specimen.height;
  std::vector<double> angles;
  for (double u = 0.0, impulse = 0.0, time = 0.0; u < values.loading.final_strain * height;) {
    simulation.step();
    const double dt = simulation.time_step();
    u += speed(simulation.state().time) * dt;
    impulse += platen_force(simulation, values) * dt;
    time += dt;
    if (u < 0.001 * static_cast<double>(angles.size() + 1) * height) continue;
    angles.push_back(mobilised_angle(impulse / time, values));
    impulse = time = 0.0;
  }
  return angles;
}

/// Few cells, fast, and ended soon after the peak; `more` takes precedence.
std::vector<std::string> short_case(const std::string& scheme_name, const std::vector<std::string>& more = {}) {
  std::vector<std::string> settings{"scheme=" + scheme_name, "grid.cells=[8, 28]",     "nonlocal.length=5e-3",
                                    "loading.speed=0.4",     "loading.ramp_time=2e-3", "loading.final_strain=0.02"};
  settings.insert(settings.end(), more.begin(), more.end());
  return settings;
}

void expect_same_curve(const std::string& what, const std::vector<double>& plane, const std::vector<double>& slab) {
  ASSERT_EQ(plane.size(), slab.size());
  double farthest = 0.0;
  for (std::size_t i = 0; i < plane.size(); ++i) farthest = std::max(farthest, std::abs(plane[i] - slab[i]));
  const auto peak = std::ranges::max_element(plane);
  std::printf("%s: peak %.2f deg at %.1f %%, %.2f deg at the end; in 3-D off by at most %.1e deg\n", what.c_str(),
              *peak, 0.1 * static_cast<double>(peak - plane.begin() + 1), plane.back(), farthest);
  EXPECT_LT(peak - plane.begin() + 1, static_cast<std::ptrdiff_t>(plane.size())) << "not past the peak";
  EXPECT_LT(farthest, 0.01) << what;
}

class Slab : public testing::TestWithParam<std::string> {};

TEST_P(Slab, OneCellThickGivesThePlaneStrainCurve) {
  const auto settings = short_case(GetParam());
  expect_same_curve(GetParam(), curve<2>(settings), curve<3>(settings));
}

TEST(SlabOfSand, GivesThePlaneStrainCurveWithRigidPointsAndPressureOnPoints) {
  const auto settings = short_case("gimp", {"loading.platen=rigid_points", "loading.lateral=points"});
  expect_same_curve("the paper's boundaries", curve<2>(settings), curve<3>(settings));
}

TEST(SlabOfSand, GivesItInSeveralCellsAndLayersOfPoints) {
  auto settings = short_case("gimp", {"specimen.points_per_cell=2", "loading.final_strain=0.018"});
  const auto plane = curve<2>(settings);
  settings.push_back("specimen.depth_cells=2");
  expect_same_curve("two cells, four layers", plane, curve<3>(settings));
}

INSTANTIATE_TEST_SUITE_P(EveryScheme, Slab, testing::ValuesIn(scheme_names()),
                         [](const auto& tested) { return tested.param; });

} // namespace
} // namespace riedel::test
