/// Closed forms at finite strain, work against energy, and the initial stress of a run.
#include "materials/neo_hookean.hpp"
#include "support/one_point.hpp"

#include <gtest/gtest.h>

namespace riedel::test {
namespace {

constexpr double E = 2e6, nu = 0.3, lambda = E * nu / ((1 + nu) * (1 - 2 * nu)), mu = E / (2 * (1 + nu));

Values rubber_values() {
  Values values(NeoHookean::parameters());
  values.set("youngs_modulus", E);
  return values;
}
std::shared_ptr<const Material> rubber() { return std::make_shared<NeoHookean>(rubber_values()); }
Sym<double> b_of(const LawBench& bench) {
  Sym<double> b;
  for (int i = 0; i < 6; ++i) b.m[static_cast<std::size_t>(i)] = bench.state[i][0];
  return b;
}
Mat<3> simple_shear(double gamma) {
  Mat<3> F = Mat<3>::Identity();
  F(0, 1) = gamma;
  return F;
}
/// Shear, stretch and out-of-plane shear, without a fixed axis; back at its start after s = 1.
Mat<3> winding_path(double s) {
  const double a = 0.8 * std::sin(2 * std::numbers::pi * s), b = 0.5 * (1 - std::cos(2 * std::numbers::pi * s));
  Mat<3> F = simple_shear(a);
  F(1, 1) += b, F(2, 0) = 0.5 * a * b, F(1, 2) = -0.3 * b;
  return F;
}

TEST(NeoHookean, IsExactInUniaxialStretchHoweverManySteps) {
  for (const double stretch : {0.3, 3.0})
    for (const int steps : {1, 50}) {
      const Sym<double> s = strained(rubber(), diagonal(0, std::log(stretch), 0), steps);
      const double volumetric = lambda * std::log(stretch) / stretch;
      expect_stress(s, {volumetric, mu / stretch * (stretch * stretch - 1) + volumetric, volumetric}, 1e-7);
    }
}

double error_in_simple_shear(int steps, bool in_halves) {
  LawBench bench = one_point(rubber());
  deformed(
      bench, [](double s) { return simple_shear(2 * s); }, steps, in_halves);
  const Sym<double> exact{{4 * mu, 0, 0, 2 * mu * std::numbers::sqrt2, 0, 0}}; // σ_11 = μ γ², σ_12 = μ γ
  return norm(bench.stress_of(0) - exact) / norm(exact);
}

/// The solver first rotates and then stretches, which is of first order; the law alone is of second.
TEST(NeoHookean, HasTheClosedFormOfSimpleShear) {
  const double coarse = error_in_simple_shear(200, false), fine = error_in_simple_shear(400, false),
               alone_coarse = error_in_simple_shear(200, true), alone_fine = error_in_simple_shear(400, true);
  std::printf("simple shear to 2: error %.2e in 200 steps, %.2e in 400; with halved rotations %.2e, %.2e\n", coarse,
              fine, alone_coarse, alone_fine);
  EXPECT_LT(coarse, 0.005);
  EXPECT_NEAR(coarse / fine, 2.0, 0.05);
  EXPECT_LT(alone_coarse, 5e-5);
  EXPECT_NEAR(alone_coarse / alone_fine, 4.0, 0.1);
}

TEST(NeoHookean, CarriesTheLeftCauchyGreenTensorOfTheDeformation) {
  LawBench bench = one_point(rubber());
  deformed(
      bench, [](double s) { return winding_path(0.4 * s); }, 2000, true);
  const Mat<3> F = winding_path(0.4);
  EXPECT_LT(norm(b_of(bench) - to_sym(F * F.transpose())), 1e-5);
  EXPECT_NEAR(std::exp(state_of(bench, "volume_strain")), F.determinant(), 1e-5);
  EXPECT_NEAR(determinant(b_of(bench)), std::exp(2 * state_of(bench, "volume_strain")), 1e-10);
}

TEST(NeoHookean, HasNoStressLeftAfterAClosedCycleOfDeformation) {
  std::array<double, 2> left, work;
  for (int i = 0; i < 2; ++i) {
    LawBench bench = one_point(rubber());
    work[static_cast<std::size_t>(i)] = std::abs(deformed(bench, winding_path, 400 << i, true)) / E;
    left[static_cast<std::size_t>(i)] = norm(bench.stress_of(0)) / E;
  }
  std::printf("closed cycle: stress over E %.1e, %.1e; work over E %.1e, %.1e\n", left[0], left[1], work[0], work[1]);
  EXPECT_LT(left[0], 1e-4);
  EXPECT_NEAR(left[0] / left[1], 4.0, 0.2);
  EXPECT_LT(work[1], 1e-4);
}

TEST(NeoHookean, StoresTheWorkThatIsDoneOnIt) {
  LawBench bench = one_point(rubber());
  const double work = deformed(
      bench, [](double s) { return winding_path(0.4 * s); }, 2000, true);
  const Mat<3> F = winding_path(0.4);
  const double ln_J = std::log(F.determinant());
  const double W = mu / 2 * ((F * F.transpose()).trace() - 3 - 2 * ln_J) + lambda / 2 * ln_J * ln_J;
  EXPECT_NEAR(work / W, 1.0, 1e-5);
}

TEST(NeoHookean, FindsTheStretchOfAGivenStress) {
  const NeoHookean law(rubber_values());
  std::mt19937 random(6);
  std::uniform_real_distribution<double> stretch(0.4, 1.6);
  for (int trial = 0; trial < 500; ++trial) {
    const Sym<double> b = rotated(diagonal(stretch(random), stretch(random), stretch(random)), slanted_rotation());
    EXPECT_LT(norm(law.stretch_under(law.stress(b)) - b), 1e-12) << trial;
  }
}

TEST(NeoHookean, TakesTheStressAtTheStartForThatOfAStretch) {
  const Sym<double> start = rotated(diagonal(-4e5, -2e5, -1e5), slanted_rotation());
  LawBench bench = one_point(rubber(), start);
  EXPECT_LT(norm(strained(bench, 1e-10 * diagonal(1, 0, 0)) - start), 1e-3);
  const Sym<double> b = b_of(bench); // undone along its own axes, the stretch leaves no stress
  const Sym<double> back = isotropic_function(spectral(b), [](double b_i) { return -0.5 * std::log(b_i); });
  EXPECT_LT(norm(strained(bench, back)), 1e-7);
  EXPECT_LT(norm(b_of(bench) - Sym<double>::identity()), 1e-13);
}

TEST(NeoHookean, ReportsAStressAtTheStartThatNoStretchGives) {
  LawBench bench = one_point(rubber(), diagonal(1e8, 1e8, 1e8));
  bench.put(0, bench.stress_of(0), 0.0, 1e-6 * diagonal(1, 0, 0));
  bench.integrate(1.0);
  EXPECT_EQ(bench.report.failures, 1);
  EXPECT_EQ(bench.stress[0][0], 1e8);
  EXPECT_EQ(bench.state[0][0], 0.0);
}

TEST(NeoHookean, TellsTheSpeedOfTheFastestWaveAtFiniteStrain) {
  std::mt19937 random(8);
  std::uniform_real_distribution<double> unit(-1.0, 1.0);
  for (int trial = 0; trial < 300; ++trial) {
    LawBench bench = one_point(rubber());
    strained(bench, 0.5 * random_rate(random));
    const double c = bench.law->assess(bench.batch).wave_speed;
    std::vector<double> state;
    for (int i = 0; i < 7; ++i) state.push_back(bench.state[i][0]);
    const Spectral principal = spectral(b_of(bench));
    const Vec<3> n = trial % 2 ? Vec<3>(principal.directions.col(0)) // the stiffest direction
                               : Vec<3>(unit(random), unit(random), unit(random)).normalized();
    const Sym<double> D = 1e-7 * to_sym(n * n.transpose()), before = bench.stress_of(0);
    const double stiffness = dot(strained(bench, D) - before, D) / dot(D, D);
    const double speed = std::sqrt(std::max(0.0, stiffness) / bench.law->density(state));
    EXPECT_LE(speed, c * (1 + 1e-6));
    EXPECT_TRUE(trial % 2 == 0 || speed >= c * (1 - 1e-6));
  }
}

} // namespace
} // namespace riedel::test
