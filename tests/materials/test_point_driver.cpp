/// The point driver against curves of independent programs and against closed forms.
#include "core/base/error.hpp"
#include "materials/legs.hpp"
#include "support/csv.hpp"

#include <gmock/gmock.h>

namespace riedel::test {
namespace {

using testing::AllOf;
using testing::HasSubstr;
double mobilised(const MaterialPoint& q) {
  const double s1 = -q.stress.m[0], s3 = -q.stress.m[1];
  return std::asin((s1 - s3) / (s1 + s3)) * degrees;
}
double sheared(const MaterialPoint& q) { return std::atan2(q.stress.m[3] / sqrt2, -q.stress.m[1]) * degrees; }

struct Curve {
  std::string name;
  double void_ratio, pressure;
  LoadStep (*leg)(double, double);
  std::string strain, angle;
  double (*angle_of)(const MaterialPoint&);
};
std::ostream& operator<<(std::ostream& out, const Curve& curve) { return out << curve.name; }

class ReferenceCurve : public testing::TestWithParam<Curve> {};

/// From each strain of the reference to the next, the error is below 0.001° for the angle, 1e-5 for the void ratio and
/// 1e-4 (relative) for σ_11: fifty times, ten times and more below what the driver must meet.
TEST_P(ReferenceCurve, IsMet) {
  const Curve& curve = GetParam();
  const Table wanted = reference("gudehus_bauer_" + curve.name + ".csv");
  const auto law = karlsruhe();
  PointDriver driver(*law, sand(curve.void_ratio, curve.pressure));
  const auto& strain = wanted.at(curve.strain);
  ASSERT_EQ(strain.size(), 200U);
  for (std::size_t i = 1; i < strain.size(); ++i) {
    ASSERT_TRUE(driver.follow(curve.leg(strain[i], curve.pressure), go_on));
    const MaterialPoint& q = driver.point();
    ASSERT_NEAR(q.state[0], wanted.at("e")[i], 1e-5) << strain[i];
    ASSERT_NEAR(-q.stress.m[0], wanted.at("sig11_Pa")[i], 1e-4 * wanted.at("sig11_Pa")[i]) << strain[i];
    if (!curve.angle.empty()) { ASSERT_NEAR(curve.angle_of(q), wanted.at(curve.angle)[i], 1e-3) << strain[i]; }
  }
}

INSTANTIATE_TEST_SUITE_P(
    All, ReferenceCurve,
    testing::Values(Curve{"oedometer_e0.60_iso1kPa", 0.60, 1e3, oedometer, "eps11_eng", "", nullptr},
                    Curve{"oedometer_e0.90_iso1kPa", 0.90, 1e3, oedometer, "eps11_eng", "", nullptr},
                    Curve{"triaxial_e0.60_p500kPa", 0.60, 500e3, triaxial, "u_h0", "phi_mob_deg", mobilised},
                    Curve{"triaxial_e0.75_p500kPa", 0.75, 500e3, triaxial, "u_h0", "phi_mob_deg", mobilised},
                    Curve{"planestrain_e0.55_p50kPa", 0.55, 50e3, plane_strain, "u_h0", "phi_mob_deg", mobilised},
                    Curve{"planestrain_e0.75_p50kPa", 0.75, 50e3, plane_strain, "u_h0", "phi_mob_deg", mobilised},
                    Curve{"planestrain_e0.90_p50kPa", 0.90, 50e3, plane_strain, "u_h0", "phi_mob_deg", mobilised},
                    Curve{"simpleshear_e0.60_sn200kPa", 0.60, 200e3, simple_shear, "gamma_u_h0", "phi_atan_deg",
                          sheared}));

/// (largest angle, strain there, last angle) in one leg.
struct Angles {
  double peak = 0, at = 0, last = 0;
};
Angles angles(double void_ratio, double pressure, const LoadStep& leg) {
  const auto law = karlsruhe();
  PointDriver driver(*law, sand(void_ratio, pressure));
  Angles found;
  driver.follow(leg, [&](const MaterialPoint& q) {
    found.last = mobilised(q);
    if (found.last > found.peak) found.peak = found.last, found.at = 1 - q.F(0, 0);
    return true;
  });
  EXPECT_LT(driver.steps(), 2000);
  return found;
}

TEST(PointDriver, EndsAtTheCriticalAngles) {
  for (const double e0 : {0.60, 0.75, 0.90}) EXPECT_NEAR(angles(e0, 500e3, triaxial(0.78, 500e3)).last, 30.0, 0.02);
  for (const double e0 : {0.55, 0.75, 0.90})
    EXPECT_NEAR(angles(e0, 50e3, plane_strain(0.78, 50e3)).last, 34.345, 0.03); // ‖σ̂*‖ = a1 at cos 3θ = 0
}

TEST(PointDriver, FindsThePeaksOfTriaxialCompression) {
  const Angles dense = angles(0.60, 500e3, triaxial(0.3, 500e3)), medium = angles(0.75, 500e3, triaxial(0.3, 500e3)),
               loose = angles(0.90, 500e3, triaxial(0.3, 500e3));
  EXPECT_NEAR(dense.peak, 38.5, 0.1);
  EXPECT_NEAR(dense.at, 0.05, 0.005);
  EXPECT_NEAR(medium.peak, 30.2, 0.05);
  EXPECT_NEAR(medium.at, 0.10, 0.02);
  EXPECT_LT(loose.peak, 30.0); // from below
  EXPECT_NEAR(loose.at, 0.3, 1e-9);
}

TEST(PointDriver, UndrainedCompressionKeepsTheVolumeAndRaisesThePressureOfDenseSand) {
  const auto law = karlsruhe();
  PointDriver driver(*law, sand(0.60, 100e3));
  const Condition equal{"sigma_2 - sigma_3", [](const MaterialPoint& q) { return q.stress.m[1] - q.stress.m[2]; }, 0.0,
                        true};
  driver.follow(leg_of(stretch(0, 0.97), volume(1), equal), [&](const MaterialPoint& q) {
    EXPECT_NEAR(q.state[0], 0.60, 1e-9);
    EXPECT_NEAR(q.F(1, 1), q.F(2, 2), 1e-9);
    return true;
  });
  EXPECT_GT(-trace(driver.point().stress), 10 * 300e3);
}

TEST(PointDriver, ShearsAnElasticPointByTheClosedFormOfTheJaumannRate) {
  const double E = 1e6, nu = 0.25, G = E / (2 * (1 + nu));
  const auto law = material("linear_elastic", {{"youngs_modulus", E}, {"poissons_ratio", nu}});
  PointDriver driver(*law, {}, {.tolerance = 1e-8});
  driver.follow(leg_of(stretch(0, 1), stretch(1, 1), stretch(2, 1), 2.0), [&](const MaterialPoint& q) {
    const double gamma = q.F(0, 1); // τ = G sin γ, σ11 = −σ22 = G (1 − cos γ)
    EXPECT_NEAR(q.stress.m[3] / sqrt2, G * std::sin(gamma), 1e-4 * G);
    EXPECT_NEAR(q.stress.m[0], G * (1 - std::cos(gamma)), 1e-4 * G);
    EXPECT_NEAR(q.stress.m[1], -G * (1 - std::cos(gamma)), 1e-4 * G);
    return true;
  });
  EXPECT_NEAR(driver.point().F(0, 1), 2.0, 1e-12);
}

TEST(PointDriver, WithoutSpinTheShearStressFollowsTheStrain) {
  const auto law = material("linear_elastic", {{"youngs_modulus", 1e6}, {"poissons_ratio", 0.25}});
  LoadStep leg = leg_of(stretch(0, 1), stretch(1, 1), stretch(2, 1));
  leg.conditions[3] = {"gamma", [](const MaterialPoint& q) { return sqrt2 * q.strain.m[3]; }, 0.5, false};
  for (std::size_t a = 0; a < 3; ++a)
    leg.conditions[a] = {"eps", [=](const MaterialPoint& q) { return q.strain.m[a]; }, 0.0, false};
  for (std::size_t c = 4; c < 6; ++c)
    leg.conditions[c] = {"gamma", [=](const MaterialPoint& q) { return q.strain.m[c]; }, 0.0, false};
  leg.motion = LoadStep::Motion::no_spin;
  PointDriver driver(*law, {});
  driver.follow(leg, go_on);
  EXPECT_NEAR(driver.point().stress.m[3] / sqrt2, 0.4e6 * 0.5, 1e-3);
  EXPECT_NEAR(driver.point().stress.m[0], 0.0, 1e-6);
}

TEST(PointDriver, ACycleOfAnElasticPointClosesAndThatOfSandReturnsItsShape) {
  const auto elastic = material("linear_elastic"), grains = karlsruhe();
  PointDriver first(*elastic, {.stress = -100e3 * Sym<double>::identity()}), second(*grains, sand(0.7, 100e3));
  for (PointDriver* driver : {&first, &second})
    for (const double gamma : {0.01, -0.01, 0.0})
      driver->follow(leg_of(stretch(0, 1), stretch(1, 1), stretch(2, 1), gamma), go_on);
  EXPECT_LT(norm(first.point().stress + 100e3 * Sym<double>::identity()), 1e-3);
  EXPECT_LT((second.point().F - Mat<3>::Identity()).norm(), 1e-10);
  EXPECT_NEAR(second.point().state[0], 0.7, 1e-9);
}

TEST(PointDriver, FollowsStressesAlone) {
  const auto law = karlsruhe();
  PointDriver driver(*law, sand(0.75, 100e3));
  driver.follow(leg_of(stress(0, -300e3), stress(1, -200e3), stress(2, -200e3)), go_on);
  EXPECT_NEAR(driver.point().stress.m[0], -300e3, 1.0);
  EXPECT_NEAR(driver.point().stress.m[2], -200e3, 1.0);
  EXPECT_LT(driver.point().state[0], 0.75);
}

TEST(PointDriver, SaysHowFarItCameWhenAStressIsBeyondTheLimit) {
  const auto law = karlsruhe();
  PointDriver driver(*law, sand(0.75, 100e3));
  try {
    driver.follow(leg_of(stress(0, -900e3), stress(1, -100e3), stress(2, -100e3)), go_on);
    FAIL();
  } catch (const RunError& error) {
    EXPECT_THAT(error.what(), AllOf(HasSubstr("sigma_1"), HasSubstr("eps_1 = 0.0"), HasSubstr("limit state")));
  }
  EXPECT_NEAR(mobilised(driver.point()), angles(0.75, 100e3, triaxial(0.1, 100e3)).peak, 0.1);
}

TEST(PointDriver, StopsWhenItIsAskedTo) {
  const auto law = karlsruhe();
  PointDriver driver(*law, sand(0.75, 100e3));
  EXPECT_FALSE(driver.follow(triaxial(0.1, 100e3), [](const MaterialPoint& q) { return 1 - q.F(0, 0) < 0.01; }));
  EXPECT_NEAR(1 - driver.point().F(0, 0), 0.01, 0.003);
}

/// The law's own tolerance of a run on a grid, a hundred times coarser, still meets 0.05° and 1e-4.
TEST(PointDriver, MeetsTheCurveWithACoarseLawToo) {
  const auto law = karlsruhe(1e-4);
  const Table wanted = reference("gudehus_bauer_planestrain_e0.55_p50kPa.csv");
  PointDriver driver(*law, sand(0.55, 50e3), {.tolerance = 1e-4});
  for (std::size_t i = 10; i < 200; i += 10) {
    driver.follow(plane_strain(wanted.at("u_h0")[i], 50e3), go_on);
    EXPECT_NEAR(mobilised(driver.point()), wanted.at("phi_mob_deg")[i], 0.05);
    EXPECT_NEAR(driver.point().state[0], wanted.at("e")[i], 1e-4);
  }
}

} // namespace
} // namespace riedel::test
