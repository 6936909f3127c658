/// Logarithmic elastic strains in elastoplastic laws: closed forms at finite strain.
#include "support/one_point.hpp"

#include <gtest/gtest.h>

namespace riedel::test {
namespace {

using Parameters = std::map<std::string, Value>;
constexpr double E = 2e6, nu = 0.3, lambda = E * nu / ((1 + nu) * (1 - 2 * nu)), mu = E / (2 * (1 + nu));

std::shared_ptr<const Material> solid(const std::string& measure, Parameters more = {}) {
  more.insert({{"youngs_modulus", E}, {"poissons_ratio", nu}, {"cohesion", 1e12}, {"strain_measure", measure}});
  return material("mohr_coulomb", more);
}
Mat<3> simple_shear(double gamma) {
  Mat<3> F = Mat<3>::Identity();
  F(0, 1) = gamma;
  return F;
}

TEST(Hencky, IsExactInUniaxialStretchHoweverManySteps) {
  for (const double stretch : {0.4, 2.5})
    for (const int steps : {1, 50}) {
      LawBench bench = one_point(solid("hencky"));
      const Sym<double> s = strained(bench, diagonal(std::log(stretch), 0, 0), steps);
      EXPECT_NEAR(s.m[0], (lambda + 2 * mu) * std::log(stretch) / stretch, 1e-7);
      EXPECT_NEAR(s.m[1], lambda * std::log(stretch) / stretch, 1e-7);
      EXPECT_NEAR(bench.law->density(std::array{0.0, state_of(bench, "volume_strain")}), 1700.0 / stretch, 1e-9);
    }
}

double error_in_simple_shear(const std::string& measure, int steps, bool in_halves = false) {
  LawBench bench = one_point(solid(measure));
  deformed(
      bench, [](double s) { return simple_shear(4 * s); }, steps, in_halves);
  const double exact = 4 * mu * std::asinh(2.0) / std::sqrt(20.0); // τ_12 = 4 μ asinh(γ/2)/√(γ² + 4)
  return std::abs(bench.stress[3][0] / std::numbers::sqrt2 / exact - 1);
}

/// The solver first rotates and then stretches, which is of first order; the law alone is of second.
TEST(Hencky, HasTheClosedFormOfSimpleShear) {
  const double coarse = error_in_simple_shear("hencky", 400), fine = error_in_simple_shear("hencky", 800),
               alone_coarse = error_in_simple_shear("hencky", 400, true),
               alone_fine = error_in_simple_shear("hencky", 800, true), small = error_in_simple_shear("small", 800);
  std::printf(
      "simple shear to 4: error %.2e in 400 steps, %.2e in 800; with halved rotations %.2e, %.2e; small strains "
      "%.2f\n",
      coarse, fine, alone_coarse, alone_fine, small);
  EXPECT_LT(coarse, 0.012);
  EXPECT_NEAR(coarse / fine, 2.0, 0.05);
  EXPECT_LT(alone_coarse, 2e-5);
  EXPECT_NEAR(alone_coarse / alone_fine, 4.0, 0.1);
  EXPECT_GT(small, 0.5) << "Jaumann's rate oscillates";
}

/// Stretch, shear, and back along another path.
Mat<3> closed_path(double s) {
  const double a = 0.5 * std::sin(2 * std::numbers::pi * s), b = 0.4 * (1 - std::cos(2 * std::numbers::pi * s));
  Mat<3> F = simple_shear(a);
  F(1, 1) += b, F(2, 0) = 0.5 * a * b;
  return F;
}

TEST(Hencky, GivesBackWhatItTookInAClosedCycle) {
  std::array<double, 2> left;
  for (int i = 0; i < 2; ++i) {
    LawBench bench = one_point(solid("hencky"));
    deformed(bench, closed_path, 200 << i, true);
    left[static_cast<std::size_t>(i)] = norm(bench.stress_of(0)) / E;
  }
  LawBench small = one_point(solid("small"));
  deformed(small, closed_path, 200, true);
  std::printf("closed cycle: stress left over E %.1e, %.1e; small strains %.1e\n", left[0], left[1],
              norm(small.stress_of(0)) / E);
  EXPECT_LT(left[0], 2e-5);
  EXPECT_NEAR(left[0] / left[1], 4.0, 0.2);
  EXPECT_GT(norm(small.stress_of(0)) / E, 1e-3);
}

TEST(Hencky, AgreesWithSmallStrainsWhereAxesAndVolumeStay) {
  for (const std::string& law : laws_with("strain_measure")) {
    Parameters with{{"youngs_modulus", E}, {"cohesion_residual", 1e3}};
    LawBench small = one_point(material(law, with), -1e4 * Sym<double>::identity());
    with["strain_measure"] = "hencky";
    LawBench hencky = one_point(material(law, with), -1e4 * Sym<double>::identity());
    const Sym<double> strain = rotated(diagonal(0.2, -0.15, -0.05), slanted_rotation());
    EXPECT_LT(norm(strained(small, strain, 10) - strained(hencky, strain, 10)), 1e-6);
    EXPECT_NEAR(state_of(hencky, "plastic_strain"), state_of(small, "plastic_strain"), 1e-12);
    EXPECT_GT(state_of(hencky, "plastic_strain"), 0.1);
  }
}

TEST(Hencky, StartsFromTheStressThatItIsGiven) {
  LawBench bench = one_point(solid("hencky"), diagonal(-3e5, -2e5, -1e5));
  const Sym<double> s = strained(bench, 1e-9 * diagonal(1, 1, 1));
  EXPECT_LT(norm(s - diagonal(-3e5, -2e5, -1e5)), 1e-2);
}

/// The strength is one of Cauchy stresses, whatever the volume has become.
TEST(Hencky, HasTheSameStrengthAtFiniteStrain) {
  for (const double psi : {0.0, 15.0}) {
    LawBench bench =
        one_point(solid("hencky", {{"cohesion", 5e3}, {"friction_angle", 30.0}, {"dilatancy_angle", psi}}));
    double stress = 0.0;
    for (int i = 0; i < 20; ++i) stress = compressed_triaxially(bench, -0.03, 0.0);
    EXPECT_NEAR(stress, -1e4 * std::numbers::sqrt3, 1e-5);
    const double volume = state_of(bench, "volume_strain"), sine = std::sin(psi * std::numbers::pi / 180);
    // plastic: ε_v/ε_1 = −2 sin ψ/(1 − sin ψ); elastic: tr τ/(3 K)
    const double J = std::exp(volume), elastic = stress * J / E;
    EXPECT_NEAR(volume - (1 - 2 * nu) * elastic, -2 * sine / (1 - sine) * (-0.6 - elastic), 1e-9);
  }
}

} // namespace
} // namespace riedel::test
