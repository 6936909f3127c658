/// The point driver under every tolerance: round-off, edges of yield surfaces, kinks, fully prescribed motions.
#include "core/base/error.hpp"
#include "materials/legs.hpp"

#include <gmock/gmock.h>

namespace riedel::test {
namespace {

using testing::AllOf;
using testing::HasSubstr;

/// Kinds of paths, with their initial states.
struct Kind {
  std::string name;
  LoadStep leg;
};
std::vector<Kind> kinds() {
  const Condition equal{"difference", [](const MaterialPoint& q) { return q.stress.m[1] - q.stress.m[2]; }, 0.0, true};
  return {{"strains", oedometer(0.002, 0)},
          {"small strains", oedometer(1e-7, 0)},
          {"triaxial", triaxial(0.002, 100e3)},
          {"plane strain", plane_strain(0.002, 100e3)},
          {"simple shear", simple_shear(0.002, 100e3)},
          {"undrained", leg_of(stretch(0, 0.998), volume(1), equal)},
          {"stresses", leg_of(stress(0, -110e3), stress(1, -105e3), stress(2, -105e3))}};
}
MaterialPoint start_of(const Material& law) {
  MaterialPoint start{.stress = -100e3 * Sym<double>::identity(), .state = law.initial_state()};
  if (const int e = state_column(law.states(), "void_ratio"); e >= 0) start.state[static_cast<std::size_t>(e)] = 0.7;
  return start;
}
MaterialPoint end_of(const Material& law, const LoadStep& leg, double tolerance) {
  PointDriver driver(law, start_of(law), {.tolerance = tolerance});
  EXPECT_TRUE(driver.follow(leg, go_on)) << tolerance;
  EXPECT_LT(driver.steps(), 300000);
  return driver.point();
}

class AnyTolerance : public testing::TestWithParam<std::string> {};

/// Round-off is not taken for an error, and results differ from those of the smallest tolerance by no more than the
/// tolerance, as far as the law's own tolerance allows.
TEST_P(AnyTolerance, IsMetByEveryLawOnEveryKindOfPath) {
  constexpr double of_law = 1e-8;
  const Keys& parameters = catalogue().materials.find(GetParam()).description.parameters;
  const bool graded = std::ranges::find(parameters, "tolerance", &Key::name) != parameters.end();
  const auto law = graded ? material(GetParam(), {{"tolerance", of_law}}) : material(GetParam());
  for (const Kind& kind : kinds()) {
    SCOPED_TRACE(kind.name);
    const MaterialPoint exact = end_of(*law, kind.leg, 1e-12);
    for (const double tolerance : {1e-3, 1e-5, 1e-7, 1e-9}) {
      const MaterialPoint end = end_of(*law, kind.leg, tolerance);
      const double error = std::max(tolerance, graded ? 5.0 * of_law : 1e-12);
      EXPECT_LT(norm(end.stress - exact.stress), error * norm(exact.stress)) << tolerance;
      EXPECT_LT((end.F - exact.F).norm(), error * (exact.F - Mat<3>::Identity()).norm() + 1e-13) << tolerance;
    }
  }
}
INSTANTIATE_TEST_SUITE_P(All, AnyTolerance, testing::ValuesIn(law_names()));

/// At an edge of the yield surface any sum of flow on the two planes keeps the lateral stresses; a symmetric state
/// remains symmetric.
TEST(PointDriver, StaysSymmetricAtTheEdgeOfAYieldSurface) {
  for (const double residual : {30.0, 25.0}) {
    const auto law = material("mohr_coulomb", {{"friction_angle_residual", residual}, {"softening_strain", 0.05}});
    const MaterialPoint exact = end_of(*law, triaxial(0.05, 100e3), 1e-10);
    EXPECT_NEAR(exact.F.determinant(), 1.0, 0.01);
    for (const double tolerance : {1e-3, 1e-4, 1e-5, 1e-6, 1e-7, 1e-8, 1e-9, 1e-12}) {
      const MaterialPoint end = end_of(*law, triaxial(0.05, 100e3), tolerance);
      EXPECT_NEAR(end.F(1, 1), end.F(2, 2), 1e-12) << tolerance;
      EXPECT_LT((end.F - exact.F).norm(), 0.05 * tolerance + 1e-10) << tolerance;
      EXPECT_LT(norm(end.stress - exact.stress), tolerance * norm(exact.stress)) << tolerance;
    }
  }
}

/// Where the directions of stress rotate, a return mapping is of first order in the step.
TEST(PointDriver, ConvergesWhereAYieldSurfaceIsFollowedAroundItsAxis) {
  for (const std::string& name : laws_with("softening_strain")) {
    const auto law = material(name);
    const MaterialPoint exact = end_of(*law, simple_shear(0.05, 50e3), 1e-9);
    for (const double tolerance : {1e-3, 1e-4, 1e-5, 1e-6}) {
      const MaterialPoint end = end_of(*law, simple_shear(0.05, 50e3), tolerance);
      EXPECT_LT(norm(end.stress - exact.stress), 3.0 * tolerance * norm(exact.stress)) << name << tolerance;
      EXPECT_LT((end.F - exact.F).norm(), 0.05 * tolerance) << name << tolerance;
    }
  }
}

/// A stress that changes by 100 Pa with every call.
class Restless final : public Material {
public:
  [[nodiscard]] std::span<const StateVariable> states() const override { return {}; }
  [[nodiscard]] double density(std::span<const double>) const override { return 2000.0; }
  void integrate(const MaterialBatch& batch, MaterialReport&) const override {
    *batch.stress[0] += 1e7 * batch.rate[0][0] * batch.time_step - 100.0;
  }
  [[nodiscard]] MaterialLimits assess(const MaterialBatch&) const override { return {.wave_speed = 70.0}; }
};

/// The message for a path that misses no condition names none.
TEST(PointDriver, SaysThatAStressJumps) {
  const Restless law;
  PointDriver driver(law, {.stress = -100e3 * Sym<double>::identity()});
  EXPECT_THAT([&] { driver.follow(oedometer(0.002, 0), go_on); },
              testing::ThrowsMessage<RunError>(AllOf(HasSubstr("the stress jumps, however short the step, beyond 0 %"),
                                                     testing::Not(HasSubstr("gives  what")))));
}

TEST(PointDriver, LeadsAConditionAlongASine) {
  const auto law = material("linear_elastic", {{"youngs_modulus", 1e6}, {"poissons_ratio", 0.0}});
  LoadStep leg = leg_of(stress(0, -20e3), stretch(1, 1), stretch(2, 1));
  leg.conditions[0].swing = -5e3;
  leg.conditions[0].phase = 0.5;
  leg.duration = 2.0;
  PointDriver driver(*law, {.stress = -10e3 * Sym<double>::identity()});
  double minimum = 1e9;
  ASSERT_TRUE(driver.follow(leg, [&](const MaterialPoint& q) {
    const double share = q.time / 2.0;
    const double wave = std::sin(2 * std::numbers::pi * share + 0.5) - std::sin(0.5);
    EXPECT_NEAR(q.stress.m[0], -10e3 - 10e3 * share - 5e3 * wave, 1e-4);
    minimum = std::min(minimum, -q.stress.m[0]);
    return true;
  }));
  EXPECT_NEAR(driver.point().stress.m[0], -20e3, 1e-4);
  EXPECT_LT(minimum, 9.5e3) << "it goes back on its way";
}

/// A stretch and a rotation at once: the stress of an elastic point is that of the stretch, rotated.
TEST(PointDriver, FollowsADeformationGradient) {
  const auto law = material("linear_elastic", {{"youngs_modulus", 1e6}, {"poissons_ratio", 0.25}});
  LoadStep leg{.conditions = {}, .motion = LoadStep::Motion::given};
  leg.deformation << 1.0, 0.4, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0; // simple shear: sigma_12 = G sin(gamma)
  PointDriver driver(*law, {}, {.tolerance = 1e-8});
  ASSERT_TRUE(driver.follow(leg, go_on));
  EXPECT_NEAR(driver.point().stress.m[3] / sqrt2, 0.4e6 * std::sin(0.4), 1.0);
  EXPECT_LT((driver.point().F - leg.deformation).norm(), 1e-7);
  leg.deformation << 0.9, -0.1, 0.0, 0.2, 1.1, 0.05, 0.0, 0.0, 1.0; // of any kind, from there on
  const Mat<3> before = driver.point().F;
  ASSERT_TRUE(driver.follow(leg, go_on));
  EXPECT_LT((driver.point().F - leg.deformation * before).norm(), 1e-7);
}

} // namespace
} // namespace riedel::test
