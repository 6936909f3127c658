/// Return to cone and apex against independent numbers, and the three ways to match Mohr and Coulomb.
#include "core/step/rotation.hpp"
#include "materials/drucker_prager.hpp"
#include "support/one_point.hpp"

#include <gtest/gtest.h>

namespace riedel::test {
namespace {

using Parameters = std::map<std::string, Value>;
constexpr double E = 2e6, nu = 0.3, c = 5e3, root_3 = std::numbers::sqrt3;
double sine_of(double degrees) { return std::sin(degrees * std::numbers::pi / 180.0); }

std::shared_ptr<const Material> soil(const std::string& cone, double psi, Parameters more = {}) {
  more.insert({{"youngs_modulus", E}, {"poissons_ratio", nu}, {"cohesion", c}, {"friction_angle", 30.0}});
  more.insert({{"dilatancy_angle", psi}, {"cone", cone}});
  return material("drucker_prager", more);
}

/// Found by solving σ = σ_trial − λ C r(σ), f(σ) = 0 with a general solver, r at the end of the step.
TEST(DruckerPrager, ReturnsToTheConeAsTheFlowRuleSays) {
  struct ReturnPoint {
    const char* cone;
    double psi;
    Vec<3> stress;
  };
  const Sym<double> strain = diagonal(9e-3, -18e-3, -4e-3);
  for (const ReturnPoint& point : {
           ReturnPoint{"extension", 10, {-7853.736667528, -39810.107388976, -23240.137385262}},
           ReturnPoint{"extension", 30, {-8912.857387913, -42918.742062909, -25286.061120319}},
           ReturnPoint{"plane_strain", 10, {-8019.220352733, -39477.115813601, -23165.614463521}},
           ReturnPoint{"plane_strain", 30, {-9544.625235791, -42811.114932640, -25561.823978718}},
       })
    expect_stress(strained(soil(point.cone, point.psi), strain), point.stress, 1e-7);
}

TEST(DruckerPrager, ReturnsToTheApex) {
  for (const double psi : {0.0, 10.0, 30.0})
    expect_stress(strained(soil("compression", psi), diagonal(3e-2, 2.9e-2, 3.1e-2)), Vec<3>::Constant(c * root_3),
                  1e-9); // c cot φ
}

TEST(DruckerPrager, CutsTheMeanTensionOff) {
  const auto law = soil("compression", 30, {{"tension_cutoff", 2e3}});
  const Sym<double> flat = strained(law, diagonal(3e-3, 1e-3, 2e-3)); // K tr ε = 10 kPa, deviator elastic
  expect_stress(flat, Vec<3>(2e3 + E / 1.3 * 1e-3, 2e3 - E / 1.3 * 1e-3, 2e3), 1e-9);
  const Sym<double> corner = strained(law, diagonal(2e-2, -6e-3, 7e-3)); // to the circle where cut-off and cone meet
  const double root_J2 = (2 * root_3 * std::cos(std::numbers::pi / 6) * c - 2 * root_3 * 0.5 * 2e3) / 2.5;
  expect_stress(corner, Vec<3>(2e3 + root_J2, 2e3 - root_J2, 2e3), 1e-9);
}

/// A cone and Mohr and Coulomb's surface have the same strength on the path for which the cone is named.
TEST(DruckerPrager, MatchesMohrAndCoulombInTriaxialCompressionAndExtension) {
  for (const double phi : {20.0, 40.0}) {
    const double k = (1 + sine_of(phi)) / (1 - sine_of(phi)), strength = 2 * c * std::sqrt(k);
    const Sym<double> start = -1e5 * Sym<double>::identity();
    LawBench compressed = one_point(soil("compression", 5, {{"friction_angle", phi}}), start);
    EXPECT_NEAR(compressed_triaxially(compressed, -0.5, -1e5), -(k * 1e5 + strength), 1e-5);
    LawBench extended = one_point(soil("extension", 5, {{"friction_angle", phi}}), start);
    EXPECT_NEAR(compressed_triaxially(extended, 0.3, -1e5), -(1e5 - strength) / k, 1e-5);
  }
}

/// Sheared in plane strain until the stress is constant: ½(σ_1 − σ_3) + ½(σ_1 + σ_3) sin φ = c cos φ.
TEST(DruckerPrager, MatchesMohrAndCoulombInPlaneStrainWhateverTheDilatancy) {
  for (const double psi : {0.0, 15.0, 30.0}) {
    LawBench bench = one_point(soil("plane_strain", psi), -5e4 * Sym<double>::identity());
    for (int i = 0; i < 400; ++i) strained(bench, 2e-3 * diagonal(1 + sine_of(psi), -1 + sine_of(psi), 0));
    const Sym<double> before = bench.stress_of(0);
    const Sym<double> s = strained(bench, 2e-3 * diagonal(1 + sine_of(psi), -1 + sine_of(psi), 0));
    EXPECT_LT(norm(s - before), 1e-7 * norm(s)) << "flow of dilatancy ψ is steady";
    const double f = 0.75 * s.m[0] - 0.25 * s.m[1] - c * root_3 / 2;
    EXPECT_NEAR(f, 0.0, 1e-6 * norm(s)) << "psi = " << psi;
  }
}

TEST(DruckerPrager, LeavesStressesOnTheConeAndTurnsWithTheFrame) {
  const Mat<3> Q = slanted_rotation();
  std::mt19937 random(4);
  LawBench plain = one_point(soil("compression", 12)), turned = one_point(soil("compression", 12));
  const double eta = 2 * root_3 * 0.5 / 2.5, xi = 2 * root_3 * (root_3 / 2) / 2.5;
  int plastic = 0;
  for (int step = 0; step < 2000; ++step) {
    const Sym<double> strain = 4e-3 * random_rate(random);
    const double before = state_of(plain, "plastic_strain");
    const Sym<double> s = strained(plain, strain);
    const double f = norm(deviator(s)) / std::numbers::sqrt2 + eta * trace(s) / 3 - xi * c;
    EXPECT_LE(f, 1e-10 * (norm(s) + c));
    plastic += state_of(plain, "plastic_strain") > before;
    EXPECT_LT(norm(strained(turned, rotated(strain, Q)) - rotated(s, Q)), 1e-9 * (norm(s) + c));
  }
  EXPECT_GT(plastic, 100);
}

TEST(DruckerPrager, DoesNotMindHowARadialPathIsSliced) {
  const Sym<double> strain = diagonal(9e-3, -18e-3, -4e-3), whole = strained(soil("extension", 10), strain);
  EXPECT_LT(norm(whole - strained(soil("extension", 10), strain, 100)), 1e-3 * norm(whole));
  const Sym<double> straight = diagonal(6e-3, -18e-3, -6e-3); // the stress deviator keeps its direction here
  const Sym<double> once = strained(soil("extension", 10), straight);
  EXPECT_LT(norm(once - strained(soil("extension", 10), straight, 100)), 1e-11 * norm(once));
}

TEST(DruckerPrager, TellsAWaveSpeedThatPlasticFlowDoesNotExceed) {
  expect_no_faster_wave(soil("compression", 0), 1);
  expect_no_faster_wave(soil("plane_strain", 30), 2);
}

} // namespace
} // namespace riedel::test
