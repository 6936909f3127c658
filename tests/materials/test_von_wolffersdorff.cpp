/// The law against an independent evaluation, an independent curve and the closed forms that it must meet.
#include "materials/von_wolffersdorff.hpp"

#include "support/csv.hpp"
#include "support/law.hpp"

#include <Eigen/Eigenvalues>
#include <cstdio>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace riedel::test {
namespace {

VonWolffersdorff sand(std::map<std::string, Value> with = {}) {
  Values values(VonWolffersdorff::parameters());
  for (auto& [key, value] : with) values.set(key, value);
  return VonWolffersdorff(values);
}

/// Evaluated once with full tensors, σ° = L_ijkl D_kl + N_ij ‖D‖, in the symbols of the paper.
TEST(VonWolffersdorff, HasTheRateOfAnIndependentEvaluation) {
  struct Case {
    Sym<double> sigma;
    double e;
    Sym<double> D, rate;
    double e_rate;
  };
  const std::vector<Case> cases{{{{-200e3, -350e3, -150e3, 40e3, -25e3, 15e3}},
                                 0.7,
                                 {{-1.0, 0.4, 0.3, 0.2, -0.5, 0.1}},
                                 {{-7560542.620320503, 52538824.45030647, 11452853.56780229, -3354797.527501027,
                                   -6191427.651561528, -705503.999062906}},
                                 -0.51},
                                {{{-1e3, -1e3, -2.2e3, 0.0, 0.3e3, 0.0}},
                                 0.9,
                                 {{0.2, -0.3, 0.6, -0.7, 0.1, 0.4}},
                                 {{452567.5743435097, 253349.7776538362, 1529079.937095013, -278904.9153655429,
                                   -189440.9720120065, 159374.2373517388}},
                                 0.95},
                                {{{-5e6, -3e6, -4e6, 1e6, 0.0, -0.5e6}},
                                 0.5,
                                 {{-0.3, -0.2, 0.5, 0.0, 0.9, -0.4}},
                                 {{248147157.4248067, 51529872.63087881, 333643264.4818125, -110562292.3605619,
                                   220565699.3447638, -42748053.52850294}},
                                 0.0}};
  for (const Case& c : cases) {
    const auto rate = sand().rate<double>(c.sigma, {c.e}, c.D, norm(c.D));
    EXPECT_LT(norm(rate.stress - c.rate), 1e-10 * norm(c.rate));
    EXPECT_NEAR(rate.state[0], c.e_rate, 1e-14);
  }
}

double friction_angle(double sigma_1, double sigma_3) {
  return std::asin((sigma_1 - sigma_3) / (sigma_1 + sigma_3)) * 180.0 / std::numbers::pi;
}

TEST(VonWolffersdorff, FollowsTheReferenceInTriaxialCompression) {
  const Table curve = reference("von_wolffersdorff_hochstetten_triax200.csv");
  LawBench bench(material("von_wolffersdorff"), 1);
  bench.put(0, -200e3 * Sym<double>::identity(), curve.at("e")[0], Sym<double>::zero());
  double strain = 0.0, angle = 0.0, density = 0.0;
  for (std::size_t row = 1; row < curve.at("e").size(); ++row) {
    const double target = curve.at("control_log_strain")[row];
    const int parts = 1 + static_cast<int>((target - strain) / 5e-5);
    for (int i = 0; i < parts; ++i) compress_in_triaxial_cell(bench, (target - strain) / parts, -200e3);
    strain = target;
    angle = std::max(angle, std::abs(friction_angle(-bench.stress_of(0).m[1], 200e3) -
                                     friction_angle(-curve.at("s22_kPa")[row], 200.0)));
    density = std::max(density, std::abs(bench.state[0][0] - curve.at("e")[row]));
  }
  std::printf("triaxial compression: greatest difference %.5f deg, %.1e in e\n", angle, density);
  EXPECT_LT(angle, 0.05);
  EXPECT_LT(density, 1e-4);
}

/// Hochstetten sand's bounds.
double shrink(double p) { return std::exp(-std::pow(3 * p / 1e9, 0.25)); }

TEST(VonWolffersdorff, StaysOnTheLimitingVoidRatioInIsotropicCompression) {
  for (const double p : {1e2, 1e3, 5e4, 1e6, 2e7}) {
    const Sym<double> D = -1.0 * Sym<double>::identity();
    const double e_i = 1.05 * shrink(p);
    const auto rate = sand().rate<double>(-p * Sym<double>::identity(), {e_i}, D, norm(D));
    const double p_dot = -trace(rate.stress) / 3;
    const double slope = -e_i * 0.25 * std::pow(3 * p / 1e9, -0.75) * 3 / 1e9; // de_i/dp
    EXPECT_NEAR(rate.state[0] / (slope * p_dot), 1.0, 1e-10) << "p = " << p;
  }
}

/// At ‖σ̂*‖ = F/a and e = e_c, flow along −σ̂* changes neither stress nor volume. @return the largest relative rate
double rate_in_critical_state(const Sym<double>& sigma) {
  const VonWolffersdorff law = sand({{"phi_c", 30.0}});
  const Sym<double> s_dev = deviator(sigma / trace(sigma)), D = (-1.0 / norm(s_dev)) * s_dev;
  const double e_c = 0.95 * shrink(-trace(sigma) / 3);
  const auto rate = law.rate<double>(sigma, {e_c}, D, norm(D)), scale = law.rate<double>(sigma, {e_c}, D, 0.0);
  return norm(rate.stress) / norm(scale.stress);
}

TEST(VonWolffersdorff, HasACriticalAngleOf30DegreesInTriaxialCompressionAndExtension) {
  EXPECT_LT(rate_in_critical_state(-1e5 * diagonal(3, 1, 1)), 1e-10); // (1 + sin 30°)/(1 − sin 30°) = 3
  EXPECT_LT(rate_in_critical_state(-1e5 * diagonal(3, 3, 1)), 1e-10);
  EXPECT_GT(rate_in_critical_state(-1e5 * diagonal(3.01, 1, 1)), 1e-3);
}

/// cos 3ϑ = 0 and F = a x give x² = 1/14.625 for φ_c = 30°, and the angle has a tangent of 2/3: Matsuoka and Nakai's.
TEST(VonWolffersdorff, HasACriticalAngleOf33Point690DegreesInPlaneStrain) {
  const double half = std::sqrt(1 / 14.625) / std::numbers::sqrt2; // σ̂ = (1/3 + half, 1/3 − half, 1/3)
  EXPECT_LT(rate_in_critical_state(-1e5 * diagonal(1 + 3 * half, 1 - 3 * half, 1)), 1e-10);
  EXPECT_NEAR(friction_angle(1 + 3 * half, 1 - 3 * half), 33.6901, 1e-4);
  EXPECT_NEAR(std::tan(std::asin(3 * half)), 2.0 / 3.0, 1e-12);
}

/// Between the meridians as well, I1 I2/I3 of the critical stress is that of triaxial compression.
TEST(VonWolffersdorff, HasItsCriticalStatesOnTheSurfaceOfMatsuokaAndNakai) {
  const double of_compression = (3 + 1 + 1) * (3 + 3 + 1) / 3.0;
  for (const double middle : {1.2, 1.5, 2.0, 2.5, 2.9}) {
    double low = middle, high = 4.0; // of the largest stress; the smallest is 1
    const auto invariant = [&](double s) { return (s + middle + 1) * (s * middle + middle + s) / (s * middle); };
    for (int i = 0; i < 100; ++i) (invariant(0.5 * (low + high)) < of_compression ? low : high) = 0.5 * (low + high);
    EXPECT_LT(rate_in_critical_state(-1e5 * diagonal(low, middle, 1)), 1e-9) << "middle stress " << middle;
  }
}

TEST(VonWolffersdorff, RatesAgreeBetweenPacksAndScalars) {
  std::mt19937 random(5);
  for (int trial = 0; trial < 50; ++trial) {
    std::array<Sym<double>, pack_size> sigma, D;
    std::array<double, pack_size> e;
    for (std::size_t k = 0; k < pack_size; ++k) {
      const double pressure = std::pow(10.0, 1.0 + 0.1 * trial);
      sigma[k] = k == 3 ? -pressure * Sym<double>::identity() : random_stress(random, pressure);
      D[k] = random_rate(random);
      e[k] = 0.45 + 0.07 * static_cast<double>(k);
    }
    const Sym<Pack> rate_of_deformation = packed(D);
    const auto together =
        unpacked(sand()
                     .rate<Pack>(packed(sigma), {Pack::load(e.data())}, rate_of_deformation, norm(rate_of_deformation))
                     .stress);
    for (std::size_t k = 0; k < pack_size; ++k) {
      const auto alone = sand().rate<double>(sigma[k], {e[k]}, D[k], norm(D[k])).stress;
      EXPECT_LT(norm(together[k] - alone), 1e-12 * norm(alone));
    }
  }
}

TEST(VonWolffersdorff, TakesTheAveragedNormInTheNTermAlone) {
  const Sym<double> sigma = -5e4 * diagonal(2, 1, 1.4), D = diagonal(-1, 0.3, 0);
  const auto rate = [&](double d) { return sand().rate<double>(sigma, {0.6}, D, d).stress; };
  EXPECT_LT(norm((rate(2 * norm(D)) - rate(0.0)) - 2.0 * (rate(norm(D)) - rate(0.0))), 1e-9 * norm(rate(norm(D))));
  EXPECT_GT(norm(rate(norm(D)) - rate(0.0)), 0.1 * norm(rate(norm(D))));
  EXPECT_EQ(sand().nonlocal_variables(), std::vector<std::string>{"rate_norm"});
}

TEST(VonWolffersdorff, HasAFiniteRateUnderTensilePrincipalStresses) {
  for (const Sym<double>& sigma : {-1e3 * diagonal(1, 0, 0), -1e3 * diagonal(3, -1, -1), -1e3 * diagonal(2, 2, -3)}) {
    const Sym<double> D = diagonal(-1, 0.3, 0.2);
    EXPECT_TRUE(std::isfinite(norm(sand().rate<double>(sigma, {0.6}, D, norm(D)).stress)));
  }
}

TEST(VonWolffersdorff, CountsVoidRatiosOutOfBounds) {
  LawBench bench(material("von_wolffersdorff"), 3);
  for (Index p = 0; p < 3; ++p)
    bench.put(p, -5e4 * Sym<double>::identity(), p == 0 ? 0.45 : p == 1 ? 0.6 : 1.0, Sym<double>::zero());
  bench.integrate(1e-6);
  EXPECT_EQ(bench.law->assess(bench.batch).out_of_bounds, 2);
}

TEST(VonWolffersdorff, RefusesVoidRatiosInTheWrongOrderAndAnExponentThatSoftensCompression) {
  const auto complaint = [](std::map<std::string, Value> with) -> std::string {
    try {
      material("von_wolffersdorff", std::move(with));
      return "none";
    } catch (const InputError& error) { return error.what(); }
  };
  EXPECT_THAT(complaint({{"e_d0", 0.96}}), testing::HasSubstr("e_d0 < e_c0 < e_i0; given 0.96, 0.95, 1.05"));
  EXPECT_THAT(complaint({{"e_c0", 1.05}}), testing::HasSubstr("e_d0 < e_c0 < e_i0"));
  // a = 2.7607: (3 + a²)/(√3 a) = 2.2213, and (e_i0 − e_d0)/(e_c0 − e_d0) = 1.25
  EXPECT_THAT(complaint({{"alpha", 3.7}}), testing::HasSubstr("allowed: (0, 3.57"));
  EXPECT_EQ(complaint({{"alpha", 3.5}}), "none");
}

} // namespace
} // namespace riedel::test
