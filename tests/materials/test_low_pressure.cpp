/// Near zero pressure: finite, frame invariant, counted, and contact regained after separation.
#include "core/step/rotation.hpp"
#include "support/law.hpp"

#include <gtest/gtest.h>

namespace riedel::test {
namespace {

/// Strains one point of sand at a constant rate, in steps of 1e-5.
LawBench strained(LawBench bench, const Sym<double>& D, double strain, const Mat<3>& Q = Mat<3>::Identity()) {
  const Sym<double> turned = rotated(D, Q);
  for (std::size_t c = 0; c < 6; ++c) bench.rate[static_cast<int>(c)][0] = turned.m[c];
  for (double done = 0.0; done < strain - 1e-12; done += 1e-5) bench.integrate(1e-5);
  return bench;
}

LawBench sand(const Sym<double>& sigma, double cohesion = 0.0) {
  LawBench bench(material("gudehus_bauer", {{"cohesion_pressure", cohesion}}), 1);
  bench.put(0, sigma, 0.6, Sym<double>::zero());
  return bench;
}

TEST(LowPressure, ExpandingSandSeparatesAndCarriesNoStressUntilItsVolumeIsBack) {
  const Sym<double> open = diagonal(1, 1, 1), close = diagonal(-1, -1, -1);
  LawBench apart = strained(sand(-1e3 * Sym<double>::identity()), open, 2e-3);
  EXPECT_EQ(norm(apart.stress_of(0)), 0.0);
  EXPECT_GT(apart.state[1][0], 0.0);
  EXPECT_GT(apart.report.separated, 0);
  EXPECT_EQ(apart.report.failures, 0);
  const double gap = apart.state[1][0];

  const LawBench half_way = strained(apart, close, gap / 3 - 2e-4);
  EXPECT_EQ(norm(half_way.stress_of(0)), 0.0);
  const LawBench back = strained(apart, close, 2e-3);
  EXPECT_EQ(back.state[1][0], 0.0);
  EXPECT_GT(-trace(back.stress_of(0)), 1e2);
  EXPECT_NEAR(back.state[0][0], 0.6, 1e-8) << "the void ratio returns with the volume";
}

TEST(LowPressure, IsFrameInvariant) {
  const Mat<3> Q = slanted_rotation();
  const Sym<double> sigma = -1e2 * diagonal(1.5, 0.7, 1.0), shear = {{0.1, -0.5, 0.0, 1.0, 0.3, -0.2}};
  for (const double cohesion : {0.0, 5.0, 200.0})
    for (const double strain : {1e-4, 1e-3, 3e-3}) {
      const LawBench plain = strained(sand(sigma, cohesion), shear, strain);
      const LawBench turned = strained(sand(rotated(sigma, Q), cohesion), shear, strain, Q);
      EXPECT_LT(norm(turned.stress_of(0) - rotated(plain.stress_of(0), Q)), 1e-6 * (1.0 + norm(plain.stress_of(0))));
    }
}

TEST(LowPressure, LooseSandShearedAtConstantVolumeIsReturnedToTheLeastPressure) {
  LawBench loose(material("gudehus_bauer"), 1);
  loose.put(0, -50.0 * Sym<double>::identity(), 1.2, Sym<double>::zero());
  loose = strained(loose, Sym<double>{{0, 0, 0, 1, 0, 0}}, 0.02);
  EXPECT_GE(-trace(loose.stress_of(0)) / 3, 10.0 * (1 - 1e-12));
  EXPECT_GT(loose.report.low_pressure, 0);
  EXPECT_EQ(loose.report.failures, 0);
}

TEST(LowPressure, AStressFreePointStartsAtTheLeastPressure) {
  const LawBench pressed = strained(sand(Sym<double>::zero()), diagonal(-1, -1, -1), 1e-4);
  EXPECT_GT(-trace(pressed.stress_of(0)) / 3, 10.0);
  EXPECT_EQ(pressed.report.failures, 0);
}

/// Hypoplastic laws, with intergranular strain and without.
class CohesiveSand : public testing::TestWithParam<std::tuple<std::string, bool>> {
protected:
  static constexpr double p_t = 3e3;
  static constexpr Index size = 45;
  /// Points under the same stress, with and without cohesion.
  static LawBench crowd(double cohesion) {
    const auto& [name, extended] = GetParam();
    LawBench bench(material(name, {{"cohesion_pressure", cohesion}, {"intergranular_strain", extended}}), size);
    std::mt19937 random(8);
    for (Index p = 0; p < size; ++p) {
      const Sym<double> sigma = random_stress(random, 200.0 * (1 + p)) + cohesion * Sym<double>::identity();
      bench.put(p, sigma, 0.7, random_rate(random));
      if (extended) bench.put_tensor("intergranular_strain", p, 5e-5 * random_rate(random));
    }
    return bench;
  }
};

TEST_P(CohesiveSand, MovesAsTheUnshiftedLawDoesAtTheShiftedStress) {
  int apart = 0;
  for (const double increment : {1e-8, 1e-5, 3e-4, 5e-3}) { // one evaluation, two, sub-steps, low pressure
    LawBench shifted = crowd(p_t), plain = crowd(0.0);
    shifted.integrate(increment);
    plain.integrate(increment);
    for (Index p = 0; p < size; ++p) {
      if (plain.state[plain.column("separation")][p] > 0.0) {
        EXPECT_EQ(norm(shifted.stress_of(p)), 0.0) << "point " << p << ", increment " << increment;
        ++apart;
      } else {
        const Sym<double> seen = shifted.stress_of(p) - p_t * Sym<double>::identity();
        EXPECT_LT(norm(seen - plain.stress_of(p)), 1e-7 * norm(plain.stress_of(p)) + 1e-9) << increment;
      }
      EXPECT_NEAR(shifted.state[0][p], plain.state[0][p], 1e-12);
    }
    EXPECT_EQ(shifted.report.failures, 0);
    EXPECT_EQ(shifted.report.evaluated_twice, plain.report.evaluated_twice);
    const LawBench &a = shifted, &b = plain;
    EXPECT_NEAR(a.law->assess(a.batch).wave_speed, b.law->assess(b.batch).wave_speed, 1e-6);
  }
  EXPECT_GT(apart, 0);
}

TEST_P(CohesiveSand, BearsTensionAndRegainsContactWithoutStress) {
  const auto& [name, extended] = GetParam();
  LawBench bench(material(name, {{"cohesion_pressure", p_t}, {"intergranular_strain", extended}}), 1);
  bench.put(0, Sym<double>::zero(), 0.7, Sym<double>::zero());
  LawBench pulled = bench;
  double maximum = 0.0; // tension
  while (pulled.state[pulled.column("separation")][0] == 0.0 && pulled.report.failures == 0) {
    maximum = std::max(maximum, trace(pulled.stress_of(0)) / 3.0);
    pulled = strained(pulled, diagonal(1, 1, 1), 1e-5);
  }
  EXPECT_GT(maximum, 0.9 * p_t);
  EXPECT_LT(maximum, p_t - 10.0);
  EXPECT_EQ(norm(pulled.stress_of(0)), 0.0);
  const double gap = pulled.state[pulled.column("separation")][0];
  const LawBench closed = strained(pulled, diagonal(-1, -1, -1), gap / 3 + 1e-5);
  EXPECT_EQ(closed.state[closed.column("separation")][0], 0.0);
  EXPECT_GT(-trace(closed.stress_of(0)), 0.0);
  EXPECT_LT(-trace(closed.stress_of(0)) / 3.0, p_t);
  EXPECT_EQ(closed.report.failures, 0);
}

INSTANTIATE_TEST_SUITE_P(Laws, CohesiveSand,
                         testing::Combine(testing::ValuesIn(laws_with("intergranular_strain")), testing::Bool()),
                         [](const auto& tested) {
                           return std::get<0>(tested.param) +
                                  (std::get<1>(tested.param) ? "_with_intergranular_strain" : "");
                         });

TEST(LowPressure, OfCohesiveSandIsReturnedInTheDirectionThatTheLawSees) {
  constexpr double p_t = 200.0;
  LawBench loose(material("gudehus_bauer", {{"cohesion_pressure", p_t}}), 1);
  loose.put(0, Sym<double>::zero(), 1.2, Sym<double>::zero());
  loose = strained(loose, Sym<double>{{0, 0, 0, 1, 0, 0}}, 0.02);
  EXPECT_GE(-trace(loose.stress_of(0)) / 3 + p_t, 10.0 * (1 - 1e-12));
  EXPECT_LT(-trace(loose.stress_of(0)) / 3 + p_t, 20.0);
  EXPECT_GT(loose.report.low_pressure, 0);
}

TEST(VoidRatio, IsHeldToItsBoundsAtThePressureThatTheLawSees) {
  for (const double cohesion : {0.0, 5e4}) { // e_i = 1.264 at 50 kPa, 1.249 at 100 kPa
    LawBench bench = sand(-5e4 * Sym<double>::identity(), cohesion);
    bench.put(0, bench.stress_of(0), 1.255, Sym<double>::zero());
    bench.integrate(1.0);
    EXPECT_EQ(bench.law->assess(bench.batch).out_of_bounds, cohesion > 0.0 ? 1 : 0);
  }
}

TEST(LowPressure, LetsAPointThatIsApartKeepTheWaveSpeedOfItsContact) {
  LawBench bench = sand(Sym<double>::zero());
  bench.state[1][0] = 1e-3;
  bench.integrate(0.0);
  const double apart = bench.law->assess(bench.batch).wave_speed;
  bench.state[1][0] = 0.0;
  bench.put(0, -10.0 * Sym<double>::identity(), 0.6, Sym<double>::zero());
  EXPECT_GT(apart, 10.0);
  EXPECT_NEAR(apart, bench.law->assess(bench.batch).wave_speed, 1e-9);
}

TEST(VoidRatio, OutsideItsBoundsIsCountedAndNotClamped) {
  LawBench bench(material("gudehus_bauer"), 3);
  for (Index p = 0; p < 3; ++p)
    bench.put(p, -5e4 * Sym<double>::identity(), p == 0 ? 0.45 : p == 1 ? 0.6 : 1.35, diagonal(0, 0, 0));
  bench.integrate(1e-6);
  EXPECT_EQ(bench.law->assess(bench.batch).out_of_bounds, 2);
  EXPECT_EQ(bench.state[0][0], 0.45);
  EXPECT_EQ(bench.state[0][2], 1.35);
}

} // namespace
} // namespace riedel::test
