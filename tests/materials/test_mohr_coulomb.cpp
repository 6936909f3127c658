/// Return mapping against numbers of independent programs, against enumeration of all planes, and against theory.
#include "core/step/rotation.hpp"
#include "materials/mohr_coulomb.hpp"
#include "support/one_point.hpp"

#include <Eigen/LU>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace riedel::test {
namespace {

using Parameters = std::map<std::string, Value>;
constexpr double E = 2e6, nu = 0.3, c = 5e3, lambda = E * nu / ((1 + nu) * (1 - 2 * nu)), mu = E / (2 * (1 + nu));
constexpr double root_3 = std::numbers::sqrt3;

/// E 2 MPa, ν 0.3, c 5 kPa, φ 30° and the given values.
std::shared_ptr<const Material> soil(double psi, Parameters more = {}) {
  more.insert({{"youngs_modulus", E}, {"poissons_ratio", nu}, {"cohesion", c}, {"friction_angle", 30.0}});
  more.insert({"dilatancy_angle", psi});
  return material("mohr_coulomb", more);
}

TEST(MohrCoulomb, ReturnsTheStressOfAnIndependentProgramInTriaxialCompression) {
  expect_stress(strained(soil(25), diagonal(5.5e-2, -12.2e-2, 8.3e-2)),
                {-53127.163022322, -176701.997142654, -53127.163022322}, 1e-8);
}

struct ReturnPoint {
  double psi;
  Vec<3> strain, stress;
};

/// Stresses found by trying all sets of up to three of the six planes, and for ψ = φ by minimising the energy norm.
TEST(MohrCoulomb, ReturnsToFaceEdgesAndApex) {
  const Vec<3> face{6e-3, -14e-3, -4e-3}, compression{4e-3, -12e-3, 3.5e-3}, extension{9e-3, -8e-3, -7.5e-3},
      apex{2e-2, 1.7e-2, 1.9e-2};
  for (const ReturnPoint& point : {
           ReturnPoint{10, face, {-5857.938842314, -34894.324602630, -20225.679033483}},
           ReturnPoint{10, compression, {-1621.660396721, -22185.489265852, -1621.660396721}},
           ReturnPoint{10, extension, {-459.310056728, -18698.438245872, -18698.438245872}},
           ReturnPoint{10, apex, {8660.254037844, 8660.254037844, 8660.254037844}},
           ReturnPoint{30, face, {-6075.445429421, -35546.844363953, -20486.686938012}},
           ReturnPoint{30, compression, {-2269.232443875, -24128.205407312, -2269.232443875}},
           ReturnPoint{30, extension, {-1264.617092752, -21114.359353945, -21114.359353945}},
           ReturnPoint{30, apex, {8660.254037844, 8660.254037844, 8660.254037844}},
       })
    expect_stress(strained(soil(point.psi), diagonal(point.strain[0], point.strain[1], point.strain[2])), point.stress,
                  1e-7);
}

TEST(MohrCoulomb, ReturnsToTheTensionCutOffItsEdgesAndWhereItMeetsTheFaces) {
  struct Cut {
    double psi, cut;
    Vec<3> strain, stress;
  };
  for (const Cut& point : {
           Cut{10, 2e3, {3e-3, -1e-3, -1.5e-3}, {2000.0, -2329.670329670, -3098.901098901}},
           Cut{10, 2e3, {3e-3, 2.5e-3, -1e-3}, {2000.0, 2000.0, -800.0}},
           Cut{10, 2e3, {3e-3, 2e-3, 2.5e-3}, {2000.0, 2000.0, 2000.0}},
           Cut{10, 1e3, {9e-3, -9e-3, -2e-3}, {1000.0, -14320.508075689, -7996.152422707}},
           Cut{30, 1e3, {9e-3, -9e-3, -1e-3}, {315.087114957, -16375.246730817, -6818.047884758}},
           Cut{10, 2e3, {7e-3, -8e-3, 6.5e-3}, {2000.0, -11320.508075689, 2000.0}},
           Cut{10, 2e3, {1.5e-2, -7e-3, -6.9e-3}, {2000.0, -11320.508075689, -11320.508075689}},
           Cut{30, 2e3, {1.5e-2, -7e-3, -6.9e-3}, {895.382907248, -14634.359353945, -14634.359353945}},
       })
    expect_stress(strained(soil(point.psi, {{"tension_cutoff", point.cut}}),
                           diagonal(point.strain[0], point.strain[1], point.strain[2])),
                  point.stress, 1e-7);
}

/// Stress after flow on some of all nine planes, whatever the order of the principal stresses; the first admissible
/// one.
std::optional<Vec<3>> by_enumeration(const Vec<3>& trial, double sin_psi, double cut) {
  std::vector<Vec<3>> normals, flows;
  std::vector<double> limits;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) {
      Vec<3> n = Vec<3>::Zero(), r = n;
      n[i] += i == j ? 1.0 : 0.75, r[i] += i == j ? 1.0 : 0.5 * (1 + sin_psi);
      if (i != j) n[j] = -0.25, r[j] = -0.5 * (1 - sin_psi);
      normals.push_back(n), flows.push_back(lambda * r.sum() * Vec<3>::Ones() + 2 * mu * r);
      limits.push_back(i == j ? cut : c * root_3 / 2);
    }
  for (int set = 0; set < 512; ++set) {
    std::vector<std::size_t> active;
    for (std::size_t k = 0; k < 9; ++k)
      if (set >> k & 1) active.push_back(k);
    const int m = static_cast<int>(active.size());
    if (m > 3) continue;
    Eigen::MatrixXd M(m, m), C_r(3, m);
    Eigen::VectorXd f(m);
    for (int a = 0; a < m; ++a) {
      f[a] = normals[active[a]].dot(trial) - limits[active[a]];
      C_r.col(a) = flows[active[a]];
      for (int b = 0; b < m; ++b) M(a, b) = normals[active[a]].dot(flows[active[b]]);
    }
    Eigen::VectorXd flow = f;
    if (m > 0) {
      const Eigen::FullPivLU<Eigen::MatrixXd> solver(M);
      flow = solver.solve(f);
      if (!solver.isInvertible() || flow.minCoeff() < 0.0) continue;
    }
    const Vec<3> sigma = trial - C_r * flow;
    bool admitted = true;
    for (std::size_t k = 0; k < 9; ++k) admitted = admitted && normals[k].dot(sigma) <= limits[k] + 1e-7;
    if (admitted) return sigma;
  }
  return {};
}

TEST(MohrCoulomb, ReturnsWhereOneSetOfPlanesLeadsForAnyTrialStress) {
  std::mt19937 random(2);
  std::uniform_real_distribution<double> stress(-4e4, 3e4);
  int found = 0;
  for (const double psi : {0.0, 5.0, 20.0, 30.0})
    for (const double cut : {1e12, 3e3}) {
      const auto law = soil(psi, {{"tension_cutoff", cut}});
      for (int trial = 0; trial < 150; ++trial) {
        const Vec<3> sigma(stress(random), stress(random), stress(random));
        const auto expected = by_enumeration(sigma, std::sin(psi * std::numbers::pi / 180), cut);
        if (!expected) { // without dilatancy no flow leads to the apex
          EXPECT_EQ(psi, 0.0);
          continue;
        }
        const Vec<3> strain = (sigma - nu * (sigma.sum() * Vec<3>::Ones() - sigma)) / E;
        expect_stress(strained(law, diagonal(strain[0], strain[1], strain[2])), *expected, 1e-6);
        ++found;
      }
    }
  EXPECT_GT(found, 1100);
}

/// Not above the surface by more than 1e-10 of the stress, wherever the axes are.
TEST(MohrCoulomb, LeavesStressesOnTheSurface) {
  std::mt19937 random(4);
  LawBench bench = one_point(soil(12));
  int plastic = 0;
  for (int step = 0; step < 3000; ++step) {
    const double before = state_of(bench, "plastic_strain");
    const Vec<3> s = principal_stresses(strained(bench, 2e-3 * random_rate(random)));
    const double f = 0.75 * s[0] - 0.25 * s[2] - c * root_3 / 2;
    EXPECT_LE(f, 1e-10 * (s.norm() + c));
    if (state_of(bench, "plastic_strain") == before) continue;
    EXPECT_GE(f, -1e-10 * (s.norm() + c));
    ++plastic;
  }
  EXPECT_GT(plastic, 300);
}

TEST(MohrCoulomb, FlowsAlongTheGradientOfThePotential) {
  const double psi = 20 * std::numbers::pi / 180;
  const Sym<double> strain = diagonal(6e-3, -14e-3, -4e-3);
  const Sym<double> sigma = strained(soil(20), strain);
  const Vec<3> s{sigma.m[0], sigma.m[1], sigma.m[2]};
  const Vec<3> elastic = (s - nu * (s.sum() * Vec<3>::Ones() - s)) / E;
  const Vec<3> flow = Vec<3>(strain.m[0], strain.m[1], strain.m[2]) - elastic;
  EXPECT_NEAR(flow[2], 0.0, 1e-15);
  EXPECT_NEAR(flow[0] / -flow[1], (1 + std::sin(psi)) / (1 - std::sin(psi)), 1e-10);
}

TEST(MohrCoulomb, TurnsWithTheFrame) {
  const Mat<3> Q = slanted_rotation();
  for (const Sym<double>& strain : {diagonal(6e-3, -14e-3, -4e-3), diagonal(4e-3, -12e-3, 3.5e-3)}) {
    const Sym<double> plain = strained(soil(10), strain), turned = strained(soil(10), rotated(strain, Q));
    EXPECT_LT(norm(turned - rotated(plain, Q)), 1e-12 * norm(plain));
  }
}

TEST(MohrCoulomb, DoesNotMindHowARadialPathIsSliced) {
  for (const Sym<double>& strain : {diagonal(6e-3, -14e-3, -4e-3), diagonal(4e-3, -12e-3, 3.5e-3)}) {
    const Sym<double> whole = strained(soil(10), strain), sliced = strained(soil(10), strain, 100);
    EXPECT_LT(norm(whole - sliced), 1e-11 * norm(whole));
  }
}

TEST(MohrCoulomb, HasTheStrengthOfTriaxialCompressionAndExtension) {
  LawBench uniaxial = one_point(soil(0)), confined = one_point(soil(10), -1e4 * Sym<double>::identity()),
           extended = one_point(soil(10), -1e5 * Sym<double>::identity());
  EXPECT_NEAR(compressed_triaxially(uniaxial, -0.05, 0.0), -2 * c * root_3, 1e-6);          // 2 c cos φ/(1 − sin φ)
  EXPECT_NEAR(compressed_triaxially(confined, -0.05, -1e4), -(3e4 + 2 * c * root_3), 1e-6); // k σ_3 + 2 c √k
  EXPECT_NEAR(compressed_triaxially(extended, 0.15, -1e5), -(1e5 - 2 * c * root_3) / 3, 1e-6);
}

/// Shear in plane strain under constant normal stresses: volume strain over shear strain is sin ψ.
TEST(MohrCoulomb, DilatesByItsAngleInPlaneStrain) {
  LawBench bench = one_point(soil(15), -5e4 * Sym<double>::identity());
  strained(bench, diagonal(0.06, -0.06, 0)); // to the surface, where a constant direction of strain keeps the stress
  const double ratio = std::sin(15 * std::numbers::pi / 180);
  const Sym<double> before = bench.stress_of(0);
  const Sym<double> after = strained(bench, 1e-3 * diagonal(1 + ratio, -1 + ratio, 0));
  EXPECT_LT(norm(after - before), 1e-10 * norm(before));
  const Sym<double> dense = strained(bench, 1e-3 * diagonal(1, -1, 0));
  EXPECT_LT(trace(dense), trace(before)); // flow without change of volume needs compression of the skeleton
}

TEST(MohrCoulomb, TellsAWaveSpeedThatPlasticFlowDoesNotExceed) {
  expect_no_faster_wave(soil(0), 1);
  expect_no_faster_wave(soil(30), 2);
}

TEST(MohrCoulomb, RefusesParametersThatContradictEachOtherAndTellsWhatIsAllowed) {
  const auto refused = [](const Parameters& given, const std::string& text) {
    EXPECT_THAT([&] { material("mohr_coulomb", given); }, testing::ThrowsMessage<InputError>(testing::HasSubstr(text)));
  };
  refused({{"dilatancy_angle", 31.0}}, "dilatancy_angle = 31.0 exceeds friction_angle; allowed: [0, 30.0] deg");
  refused({{"cohesion_residual", 6e3}}, "cohesion_residual = 6000.0 exceeds cohesion; allowed: [0, 5000.0] Pa");
  refused({{"friction_angle_residual", 40.0}}, "allowed: [0, 30.0] deg");
  refused({{"dilatancy_angle", 20.0}, {"friction_angle_residual", 10.0}}, "residual dilatancy angle, 20");
  refused({{"cohesion", 0.0}, {"friction_angle", 0.0}}, "leave no strength");
  refused({{"tension_cutoff", -1.0}}, "tension_cutoff = -1 is out of range; allowed: ≥ 0 Pa");
}

} // namespace
} // namespace riedel::test
