/// One cell of sand in plane strain compression with complete steps, against curves of independent programs. The cell
/// holds four points: a single one gives every node the same velocity, so that its stretching has no inertia.
#include "apps/biaxial/keys.hpp"
#include "apps/biaxial/specimen.hpp"
#include "support/csv.hpp"
#include "support/problems.hpp"

#include <cstdio>
#include <gtest/gtest.h>

namespace riedel::test {
namespace {

struct Curve {
  std::vector<double> strain, angle, void_ratio;
};

/// A 10 mm cube's section, strained at 0.2/s, without weight or weak patch. The angle is that of the points' mean
/// stress.
Curve compress_one_cell(const std::string& scheme_name, const std::string& order, double e_0,
                        const std::string& locking) {
  CaseFile file = CaseFile::empty();
  const std::string e = exact_text(e_0);
  for (const std::string& setting :
       {"scheme=" + scheme_name, "time.order=" + order, "time.locking=" + locking, std::string("specimen.width=0.01"),
        std::string("specimen.height=0.01"), "specimen.void_ratio=" + e, "imperfection.void_ratio=" + e,
        std::string("imperfection.size=[1e-3, 1e-3]"), std::string("imperfection.centre=[0.5, 0.5]"),
        std::string("grid.cells=[1, 1]"), std::string("loading.speed=0.002"), std::string("loading.final_strain=0.051"),
        std::string("loading.gravity=0.0"), std::string("specimen.points_per_cell=2"),
        std::string("nonlocal.length=0.0"),
        std::string("time.flip=0.98")}) // by time, one cell damps its own stretching
    file.override_with(setting);
  const BiaxialCase values(biaxial_case(file, catalogue()).values);
  Simulation<2> simulation = make_biaxial(values, catalogue());
  const auto speed = ramped(0.002, values.loading.ramp_time);
  Curve curve;
  double u = 0.0;
  while (u < 0.051 * 0.01) {
    simulation.step();
    u += speed(simulation.state().time) * simulation.time_step();
    const Points<2>& points = simulation.state().bodies[0].points;
    double lateral = 0.0, axial = 0.0, void_ratio = 0.0;
    for (Index p = 0; p < points.size(); ++p) {
      lateral -= points.stress[0][p] / points.size();
      axial -= points.stress[1][p] / points.size();
      void_ratio += points.state[0][p] / points.size();
    }
    curve.strain.push_back(u / 0.01);
    curve.angle.push_back(std::asin((axial - lateral) / (axial + lateral)) * 180 / std::numbers::pi);
    curve.void_ratio.push_back(void_ratio);
  }
  return curve;
}

/// Past that, domains that reach beyond the bulging cell's edge lose homogeneity under MUSL (0.15° at 6 % for cpgimp).
/// Largest differences from the reference between 0.1 % and 5 %.
void follow(const std::string& scheme_name, const std::string& order, double e_0, const std::string& file,
            const std::string& locking = "none") {
  const Curve curve = compress_one_cell(scheme_name, order, e_0, locking);
  const Table table = reference(file);
  double angle = 0.0, density = 0.0;
  for (std::size_t row = 0; row < table.at("u_h0").size(); ++row) {
    const double strain = table.at("u_h0")[row];
    if (strain < 0.001 || strain > 0.0501) continue;
    angle = std::max(angle, std::abs(interpolate(curve.strain, curve.angle, strain) - table.at("phi_mob_deg")[row]));
    density = std::max(density, std::abs(interpolate(curve.strain, curve.void_ratio, strain) - table.at("e")[row]));
  }
  std::printf("%-7s %-5s e0 %.2f: greatest difference %.4f deg, %.1e in e\n", scheme_name.c_str(), order.c_str(), e_0,
              angle, density);
  EXPECT_LT(angle, 0.1) << scheme_name << ", e0 = " << e_0;
  EXPECT_LT(density, 2e-4) << scheme_name << ", e0 = " << e_0;
}

class OneCell : public testing::TestWithParam<std::string> {};

TEST_P(OneCell, FollowsTheReferenceOfHomogeneousPlaneStrainCompression) {
  follow(GetParam(), "musl", 0.55, "gudehus_bauer_planestrain_e0.55_p50kPa.csv");
  follow(GetParam(), "musl", 0.75, "gudehus_bauer_planestrain_e0.75_p50kPa.csv");
  follow(GetParam(), "musl", 0.90, "gudehus_bauer_planestrain_e0.90_p50kPa.csv");
}
TEST_P(OneCell, FollowsTheReferenceInEveryOrderOfTheStep) {
  for (const std::string order : {"usl", "usf"})
    follow(GetParam(), order, 0.55, "gudehus_bauer_planestrain_e0.55_p50kPa.csv");
}
/// Not in USL: the large strains from its nearly empty nodes reach all points of a cell through the mean (12° to 29°).
TEST_P(OneCell, FollowsTheReferenceWithFBar) {
  for (const std::string order : {"musl", "usf"})
    follow(GetParam(), order, 0.55, "gudehus_bauer_planestrain_e0.55_p50kPa.csv", "f_bar");
}

INSTANTIATE_TEST_SUITE_P(Registry, OneCell, testing::ValuesIn(scheme_names()),
                         [](const auto& tested) { return tested.param; });

} // namespace
} // namespace riedel::test
