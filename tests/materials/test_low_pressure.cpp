/// Near zero pressure: finite, frame invariant, counted, and back where it came from.
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

LawBench sand(const Sym<double>& sigma) {
  LawBench bench(material("gudehus_bauer"), 1);
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
  for (const double strain : {1e-4, 1e-3, 3e-3}) {
    const LawBench plain = strained(sand(sigma), shear, strain);
    const LawBench turned = strained(sand(rotated(sigma, Q)), shear, strain, Q);
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

TEST(VoidRatio, OutsideItsBoundsIsCountedAndNotClamped) {
  LawBench bench(material("gudehus_bauer"), 3);
  for (Index p = 0; p < 3; ++p)
    bench.put(p, -5e4 * Sym<double>::identity(), p == 0 ? 0.45 : p == 1 ? 0.6 : 1.35, diagonal(0, 0, 0));
  bench.integrate(1e-6);
  EXPECT_EQ(bench.law->survey(bench.batch).out_of_bounds, 2);
  EXPECT_EQ(bench.state[0][0], 0.45);
  EXPECT_EQ(bench.state[0][2], 1.35);
}

} // namespace
} // namespace riedel::test
