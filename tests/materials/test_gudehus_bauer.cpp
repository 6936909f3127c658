/// The closed forms that the law must meet, however it is integrated.
#include "core/step/rotation.hpp"
#include "materials/gudehus_bauer.hpp"
#include "support/csv.hpp"
#include "support/law.hpp"

#include <Eigen/Eigenvalues>
#include <gtest/gtest.h>

namespace riedel::test {
namespace {

const GudehusBauer& karlsruhe() {
  static const GudehusBauer law{Values(GudehusBauer::parameters())};
  return law;
}
double degrees(double radians) { return radians * 180.0 / std::numbers::pi; }

/// Karlsruhe sand's bound e_i and its derivative with respect to p.
double e_i(double p) { return 1.3 * std::exp(-std::pow(3 * p / 190e6, 0.5)); }
double e_c(double p) { return 0.82 * std::exp(-std::pow(3 * p / 190e6, 0.5)); }

TEST(GudehusBauer, StaysOnTheLimitingVoidRatioInIsotropicCompression) {
  for (const double p : {1e2, 1e3, 5e4, 1e6, 2e7}) {
    const Sym<double> D = -1.0 * Sym<double>::identity();
    const auto rate = karlsruhe().rate<double>(-p * Sym<double>::identity(), {e_i(p)}, D, norm(D));
    const double p_dot = -trace(rate.stress) / 3;
    const double slope = -e_i(p) * 0.5 * std::pow(3 * p / 190e6, -0.5) * 3 / 190e6; // de_i/dp
    EXPECT_NEAR(rate.state[0] / (slope * p_dot), 1.0, 1e-10) << "p = " << p;
  }
}

/// At ‖σ̂*‖ = a1 and e = e_c, flow along −σ̂* changes neither stress nor volume. @return the largest relative rate
double rate_in_critical_state(const Sym<double>& sigma) {
  const Sym<double> s_dev = deviator(sigma / trace(sigma)), D = (-1.0 / norm(s_dev)) * s_dev;
  const auto rate = karlsruhe().rate<double>(sigma, {e_c(-trace(sigma) / 3)}, D, norm(D));
  const auto scale = karlsruhe().rate<double>(sigma, {e_c(-trace(sigma) / 3)}, D, 0.0); // the L-term alone
  return norm(rate.stress) / norm(scale.stress);
}

TEST(GudehusBauer, HasACriticalAngleOf30DegreesInTriaxialCompressionAndExtension) {
  const double K = (1 + std::sin(std::numbers::pi / 6)) / (1 - std::sin(std::numbers::pi / 6));
  EXPECT_LT(rate_in_critical_state(-1e5 * diagonal(K, 1, 1)), 1e-10);
  EXPECT_LT(rate_in_critical_state(-1e5 * diagonal(K, K, 1)), 1e-10);
}

TEST(GudehusBauer, HasACriticalAngleOf34Point345DegreesInPlaneStrain) {
  // D_zz = 0 puts σ_zz at the mean of σ_xx and σ_yy, so cos 3θ = 0 and x (c1 + c2 x) = 1 for x = ‖σ̂*‖.
  const double c1 = 3.061862178478973, c2 = 2.625;
  const double x = (-c1 + std::sqrt(c1 * c1 + 4 * c2)) / (2 * c2);
  EXPECT_NEAR(x, 0.265957, 1e-6);
  const double half = x / std::numbers::sqrt2; // σ̂ = (1/3 + half, 1/3 − half, 1/3)
  EXPECT_LT(rate_in_critical_state(-1e5 * diagonal(1 + 3 * half, 1 - 3 * half, 1)), 1e-10);
  EXPECT_NEAR(degrees(std::asin(3 * half)), 34.345, 5e-4);
}

TEST(GudehusBauer, RatesAgreeBetweenPacksAndScalars) {
  std::mt19937 random(5);
  for (int trial = 0; trial < 50; ++trial) {
    std::array<Sym<double>, pack_size> sigma, D;
    std::array<double, pack_size> e;
    Sym<Pack> packed_sigma, packed_D;
    for (std::size_t k = 0; k < pack_size; ++k) {
      sigma[k] = random_stress(random, std::pow(10.0, 1.0 + 0.1 * trial));
      D[k] = random_rate(random);
      e[k] = 0.55 + 0.05 * static_cast<double>(k);
    }
    for (std::size_t c = 0; c < 6; ++c) {
      std::array<double, pack_size> s, d;
      for (std::size_t k = 0; k < pack_size; ++k) s[k] = sigma[k].m[c], d[k] = D[k].m[c];
      packed_sigma.m[c] = Pack::load(s.data());
      packed_D.m[c] = Pack::load(d.data());
    }
    const auto packed = karlsruhe().rate<Pack>(packed_sigma, {Pack::load(e.data())}, packed_D, norm(packed_D));
    for (std::size_t k = 0; k < pack_size; ++k) {
      const auto alone = karlsruhe().rate<double>(sigma[k], {e[k]}, D[k], norm(D[k]));
      for (std::size_t c = 0; c < 6; ++c) {
        std::array<double, pack_size> lane;
        packed.stress.m[c].store(lane.data());
        EXPECT_NEAR(lane[k], alone.stress.m[c], 1e-12 * norm(alone.stress));
      }
    }
  }
}

TEST(GudehusBauer, IsIsotropic) {
  std::mt19937 random(9);
  const Mat<3> Q = slanted_rotation();
  for (int trial = 0; trial < 50; ++trial) {
    const Sym<double> sigma = random_stress(random, 5e4), D = random_rate(random);
    const auto plain = karlsruhe().rate<double>(sigma, {0.6}, D, norm(D));
    const auto turned = karlsruhe().rate<double>(rotated(sigma, Q), {0.6}, rotated(D, Q), norm(D));
    EXPECT_LT(norm(turned.stress - rotated(plain.stress, Q)), 1e-10 * norm(plain.stress));
  }
}

TEST(GudehusBauer, TakesTheAveragedNormInTheNTermAlone) {
  const Sym<double> sigma = -5e4 * diagonal(2, 1, 1.4), D = diagonal(-1, 0.3, 0);
  const auto local = karlsruhe().rate<double>(sigma, {0.6}, D, norm(D)),
             none = karlsruhe().rate<double>(sigma, {0.6}, D, 0.0),
             twice = karlsruhe().rate<double>(sigma, {0.6}, D, 2 * norm(D));
  EXPECT_LT(norm((twice.stress - none.stress) - 2.0 * (local.stress - none.stress)), 1e-9 * norm(local.stress));
  EXPECT_GT(norm(local.stress - none.stress), 0.1 * norm(local.stress));
}

/// Oedometric compression needs no mixed control: D_11 alone. Compares with the independent curve.
void follow_oedometer(double e_0, const std::string& file) {
  const Table curve = reference(file);
  LawBench bench(material("gudehus_bauer"), 1);
  bench.put(0, -1e3 * Sym<double>::identity(), e_0, diagonal(-1, 0, 0));
  double strain = 0.0;
  for (std::size_t row = 1; row < curve.at("eps11_log").size(); ++row) {
    const double target = curve.at("eps11_log")[row];
    const int parts = 1 + static_cast<int>((target - strain) / 1e-5);
    for (int i = 0; i < parts; ++i) bench.integrate((target - strain) / parts);
    strain = target;
    EXPECT_NEAR(-bench.stress_of(0).m[0] / curve.at("sig11_Pa")[row], 1.0, 2e-4) << "row " << row;
    EXPECT_NEAR(-bench.stress_of(0).m[1] / curve.at("sig22_Pa")[row], 1.0, 2e-4) << "row " << row;
    EXPECT_NEAR(bench.state[0][0], curve.at("e")[row], 1e-6) << "row " << row;
  }
}

TEST(GudehusBauer, FollowsTheReferenceInOedometricCompression) {
  follow_oedometer(0.60, "gudehus_bauer_oedometer_e0.60_iso1kPa.csv");
  follow_oedometer(0.90, "gudehus_bauer_oedometer_e0.90_iso1kPa.csv");
}

/// (A1)–(A10) evaluated independently, in the paper's symbols, point by point.
double wave_speed(const Sym<double>& sigma, double e) {
  const double P = -trace(sigma), shrink = std::exp(-std::pow(P / 190e6, 0.5)), e_i = 1.3 * shrink;
  const double f_d = std::pow(std::max(0.0, (e - 0.51 * shrink) / (0.31 * shrink)), 0.3), c1 = 3.061862178478973;
  const double h_i = 1 / (c1 * c1) + 1.0 / 3 - std::pow(0.79 / 0.31, 0.3) / (c1 * std::sqrt(3.0));
  const double f_s = 190e6 / (0.5 * h_i) * (e_i / e) * (1 + e_i) / e_i * std::pow(P / 190e6, 0.5);
  const Eigen::SelfAdjointEigenSolver<Mat<3>> principal(to_matrix(sigma / trace(sigma)));
  const Sym<double> s_dev = deviator(sigma / trace(sigma));
  const double a = 1 / (c1 + 2.625 * norm(s_dev) * (1 + cos_3_lode(s_dev))), s_nn = principal.eigenvalues()[2];
  return std::sqrt(f_s * (a * a + s_nn * s_nn + f_d * a * (2 * s_nn - 1.0 / 3)) * (1 + e) / 2650);
}

TEST(GudehusBauer, SurveysPacksAsItDoesPoints) {
  constexpr Index size = 45;
  std::mt19937 random(8);
  LawBench bench(material("gudehus_bauer"), size);
  for (Index p = 0; p < size; ++p)
    bench.put(p, random_stress(random, 1e3 * (1 + p)), 0.47 + 0.02 * p, Sym<double>::zero());
  bench.stress[1][7] = bench.stress[0][7] = bench.stress[2][7] = 1e9; // no pressure, no stiffness
  bench.state[1][9] = 1e-3;                                           // separated
  for (const Range part : {Range{0, 45}, Range{3, 4}, Range{5, 16}, Range{40, 45}}) {
    double fastest = 0.0;
    std::int64_t outside = 0;
    for (Index p = part.begin; p < part.end; ++p) {
      if (p == 7 || p == 9) continue;
      const double pressure = -trace(bench.stress_of(p)) / 3, e = bench.state[0][p];
      fastest = std::max(fastest, wave_speed(bench.stress_of(p), e));
      outside += e < 0.51 / 1.3 * e_i(pressure) || e > e_i(pressure);
    }
    bench.integrate(0.0, part); // fills the batch
    const MaterialLimits survey = bench.law->assess(bench.batch);
    EXPECT_NEAR(survey.wave_speed, fastest, 1e-11 * fastest);
    EXPECT_EQ(survey.out_of_bounds, outside);
  }
}

TEST(GudehusBauer, RefusesVoidRatiosInTheWrongOrderAndANegativeCompressionFactor) {
  EXPECT_THROW(material("gudehus_bauer", {{"e_d0", 0.9}}), InputError);
  EXPECT_THROW(material("gudehus_bauer", {{"phi_c", 90.0}}), InputError);
  EXPECT_THROW(material("gudehus_bauer", {{"alpha", 3.0}}), InputError); // h_i < 0
}

} // namespace
} // namespace riedel::test
