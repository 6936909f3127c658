/// How RateLaw integrates: one evaluation of the rate or two, packs or single points.
#include "materials/gudehus_bauer.hpp"
#include "support/law.hpp"

#include <gtest/gtest.h>

namespace riedel::test {
namespace {

/// Sand whose author wrote the rate for one point at a time.
class OneByOne final : public RateLaw<OneByOne, 1> {
public:
  static constexpr bool frictional = true;
  explicit OneByOne(const Values& given) : RateLaw(IntegrationControl(given)), sand_(given) {}

  [[nodiscard]] Rate<double, 1> rate(const Sym<double>& sigma, const std::array<double, 1>& state, const Sym<double>& D,
                                     double d) const {
    return sand_.rate<double>(sigma, state, D, d);
  }
  [[nodiscard]] std::span<const StateVariable> states() const override { return sand_.states(); }
  [[nodiscard]] double density(std::span<const double> state) const override { return sand_.density(state); }
  [[nodiscard]] MaterialLimits assess(const MaterialBatch& batch) const override { return sand_.assess(batch); }

private:
  GudehusBauer sand_;
};
static_assert(RunsOnPacks<GudehusBauer, 1> && !RunsOnPacks<OneByOne, 1>);

Values sand_values(double tolerance = 1e-4) {
  Values values(GudehusBauer::parameters());
  values.set("tolerance", tolerance);
  return values;
}
template <class Law>
std::shared_ptr<const Material> sand(double tolerance = 1e-4) {
  return std::make_shared<Law>(sand_values(tolerance));
}

/// Points of varied stress, density and rate; the strain increments span those of steps of 1 s.
LawBench crowd(std::shared_ptr<const Material> law, Index size, double smallest, double largest) {
  LawBench bench(std::move(law), size);
  std::mt19937 random(21);
  for (Index p = 0; p < size; ++p) {
    const double increment = smallest * std::pow(largest / smallest, double(p) / size);
    const Sym<double> sigma = random_stress(random, 2e3 * (1 + p));
    bench.put(p, sigma, 0.6 + 0.002 * p, increment * random_rate(random));
  }
  return bench;
}

TEST(RateLaw, IntegratesALawWrittenForOnePointAsItDoesOneWrittenForPacks) {
  for (const double size_of_step : {1e-7, 1e-5, 1e-3}) { // one evaluation, two, sub-steps
    LawBench packs = crowd(sand<GudehusBauer>(), 45, size_of_step, 10 * size_of_step);
    LawBench points = crowd(sand<OneByOne>(), 45, size_of_step, 10 * size_of_step);
    packs.integrate(1.0);
    points.integrate(1.0);
    for (Index p = 0; p < 45; ++p) {
      EXPECT_LE(norm(packs.stress_of(p) - points.stress_of(p)), 1e-12 * norm(points.stress_of(p))) << "point " << p;
      EXPECT_NEAR(packs.state[0][p], points.state[0][p], 1e-12 * points.state[0][p]) << "point " << p;
    }
    EXPECT_EQ(packs.report.evaluated_twice, points.report.evaluated_twice);
    EXPECT_EQ(packs.report.substepped, points.report.substepped);
    EXPECT_EQ(packs.report.failures, 0);
  }
}

/// Its stress is always admissible, its state never; a check of the stress alone does not find that.
class BrokenState final : public RateLaw<BrokenState, 1> {
public:
  static constexpr bool frictional = false;
  explicit BrokenState(const Values& given) : RateLaw(IntegrationControl(given)) {}
  template <class Real>
  Rate<Real, 1> rate(const Sym<Real>&, const std::array<Real, 1>&, const Sym<Real>& D, Real) const {
    return {.stress = D, .state = {Real(0.0) / Real(0.0)}};
  }
  [[nodiscard]] std::span<const StateVariable> states() const override { return states_; }
  [[nodiscard]] double density(std::span<const double>) const override { return 1.0; }
  [[nodiscard]] MaterialLimits assess(const MaterialBatch&) const override { return {}; }

private:
  std::vector<StateVariable> states_{{"broken", "-", "NaN as soon as it moves"}};
};

TEST(RateLaw, NeverAcceptsAStateThatIsNotANumber) {
  for (const double increment : {1e-9, 1e-2}) { // one evaluation, two
    LawBench bench(sand<BrokenState>(), 3);
    for (Index p = 0; p < 3; ++p) bench.put(p, Sym<double>::identity(), 0.0, increment * diagonal(1, 0, 0));
    bench.integrate(1.0);
    EXPECT_EQ(bench.report.failures, 3);
    EXPECT_EQ(bench.state[0][1], 0.0);
  }
}

TEST(RateLaw, ReportsTheFailuresOfALawWrittenForOnePoint) {
  LawBench bench = crowd(sand<OneByOne>(), 20, 1e-6, 1e-6);
  const Sym<double> before = bench.stress_of(13);
  bench.rate[1][13] = std::numeric_limits<double>::quiet_NaN();
  bench.integrate(1.0);
  EXPECT_EQ(bench.report.failures, 1);
  EXPECT_EQ(bench.report.first_failure, 13);
  EXPECT_EQ(norm(bench.stress_of(13) - before), 0.0);
}

TEST(RateLaw, TakesOneEvaluationWhereTheStepChangesLittleAndTwoElsewhere) {
  LawBench bench = crowd(sand<GudehusBauer>(), 64, 1e-9, 1e-3);
  const LawBench before = bench;
  bench.integrate(1.0);
  std::int64_t twice = 0;
  for (Index p = 0; p < 64; ++p) {
    Sym<double> D;
    for (std::size_t c = 0; c < 6; ++c) D.m[c] = before.rate[static_cast<int>(c)][p];
    const auto first = GudehusBauer(sand_values()).rate<double>(before.stress_of(p), {before.state[0][p]}, D, norm(D));
    const Sym<double> euler = before.stress_of(p) + first.stress;
    const double change = norm(first.stress) / norm(before.stress_of(p));
    const double difference = norm(bench.stress_of(p) - euler) / norm(euler);
    if (change <= 4e-4)
      EXPECT_LT(difference, 1e-14) << "change " << change;
    else
      EXPECT_GT(difference, 1e-13) << "change " << change;
    twice += change > 4e-4;
  }
  EXPECT_EQ(bench.report.evaluated_twice, twice);
  EXPECT_GT(twice, 10);
  EXPECT_LT(twice, 54);
}

TEST(RateLaw, TakesOneEvaluationOfARateThatIsConstantHoweverLargeTheStep) {
  LawBench bench = crowd(material("linear_elastic"), 20, 1e-9, 10.0);
  bench.integrate(1.0);
  EXPECT_EQ(bench.report.evaluated_twice, 0);
  EXPECT_EQ(bench.report.failures, 0);
}

double friction_angle(const Sym<double>& sigma) {
  return std::asin((sigma.m[0] - sigma.m[1]) / -(sigma.m[0] + sigma.m[1])) * 180.0 / std::numbers::pi;
}
struct Errors {
  double stress = 0.0, angle = 0.0; ///< relative; in degrees
};

/// Follows a path in steps as large as one evaluation may take, and once more exactly. @return the largest differences
template <class Path>
Errors errors_of_one_evaluation(double void_ratio, const Path& D_at) {
  const GudehusBauer law{sand_values()};
  LawBench once(sand<GudehusBauer>(), 1), exact(sand<GudehusBauer>(1e-9), 1);
  once.put(0, -5e4 * Sym<double>::identity(), void_ratio, Sym<double>::zero());
  exact.put(0, -5e4 * Sym<double>::identity(), void_ratio, Sym<double>::zero());
  Errors worst;
  for (double strain = 0.0; strain < 0.01;) {
    const Sym<double> sigma = once.stress_of(0), D = D_at(strain);
    const double speed = norm(law.rate<double>(sigma, {once.state[0][0]}, D, norm(D)).stress);
    const double dt = std::min(3.99e-4 * norm(sigma) / speed, 1e-4);
    once.put(0, sigma, once.state[0][0], D);
    exact.put(0, exact.stress_of(0), exact.state[0][0], D);
    once.integrate(dt);
    exact.integrate(dt);
    strain += dt;
    const Sym<double> s = exact.stress_of(0);
    if (-trace(s) < 3e4) break;
    worst.stress = std::max(worst.stress, norm(once.stress_of(0) - s) / norm(s));
    worst.angle = std::max(worst.angle, std::abs(friction_angle(once.stress_of(0)) - friction_angle(s)));
  }
  EXPECT_EQ(once.report.evaluated_twice, 0);
  return worst;
}

/// Compression, shear at constant volume, nearly drained compression: Euler lags by half a step at most.
TEST(RateLaw, StaysWithinTwiceAndAHalfTheToleranceOfTheExactPathWithOneEvaluationPerStep) {
  Errors worst;
  for (const Sym<double>& D : {diagonal(-1, 0, 0), diagonal(1, -1, 0), diagonal(0.75, -1, 0)})
    for (const double void_ratio : {0.55, 0.75, 0.90}) {
      const Errors errors = errors_of_one_evaluation(void_ratio, [&](double) { return D; });
      worst = {std::max(worst.stress, errors.stress), std::max(worst.angle, errors.angle)};
    }
  std::printf("one evaluation per step, loading: stress within %.2e, angle within %.4f deg\n", worst.stress,
              worst.angle);
  EXPECT_LT(worst.stress, 2.5e-4);
  EXPECT_LT(worst.angle, 0.02);
}

/// A pressure that is removed again still matters: an error at the large pressure weighs more at the small one.
TEST(RateLaw, StaysWithinTenTimesTheToleranceWhereSandIsUnloadedAgain) {
  Errors worst;
  for (const double void_ratio : {0.55, 0.75, 0.90}) {
    const Errors errors = errors_of_one_evaluation(
        void_ratio, [](double strain) { return strain < 5e-3 ? diagonal(0.75, -1, 0) : diagonal(-0.75, 1, 0); });
    worst = {std::max(worst.stress, errors.stress), std::max(worst.angle, errors.angle)};
  }
  std::printf("one evaluation per step, unloading: stress within %.2e, angle within %.4f deg\n", worst.stress,
              worst.angle);
  EXPECT_LT(worst.stress, 1e-3);
  EXPECT_LT(worst.angle, 0.03);
}

/// Elastic waves strain a point cyclically. The law then loses pressure by itself; Euler must not add to it.
TEST(RateLaw, AddsLittleToTheLossOfPressureUnderVibration) {
  LawBench once(sand<GudehusBauer>(), 1), exact(sand<GudehusBauer>(1e-9), 1);
  for (LawBench* bench : {&once, &exact}) {
    bench->put(0, -5e4 * Sym<double>::identity(), 0.6, Sym<double>::zero());
    std::mt19937 random(4);
    for (int step = 0; step < 20000; ++step) {
      bench->put(0, bench->stress_of(0), bench->state[0][0], (step % 2 ? -2e-7 : 2e-7) * random_rate(random));
      bench->integrate(1.0);
    }
  }
  const double loss = std::log(trace(exact.stress_of(0)) / -1.5e5),
               with_euler = std::log(trace(once.stress_of(0)) / -1.5e5);
  std::printf("vibration: loss of pressure %.4f, with one evaluation %.4f; %.0f of 20000 steps took two\n", -loss,
              -with_euler, double(once.report.evaluated_twice));
  EXPECT_LT(loss, -0.3);
  EXPECT_NEAR(with_euler / loss, 1.0, 0.01);
}

TEST(RateLaw, MeetsTheToleranceInStepsOfAnySize) {
  for (const double size_of_step : {1e-6, 1e-5, 1e-4, 1e-3}) {
    LawBench bench = crowd(sand<GudehusBauer>(), 40, size_of_step, size_of_step);
    LawBench fine = crowd(sand<GudehusBauer>(1e-8), 40, size_of_step, size_of_step);
    bench.integrate(1.0);
    for (int part = 0; part < 100; ++part) fine.integrate(0.01);
    for (Index p = 0; p < 40; ++p)
      EXPECT_LT(norm(bench.stress_of(p) - fine.stress_of(p)), 5e-4 * norm(fine.stress_of(p)))
          << "point " << p << ", step " << size_of_step;
  }
}

} // namespace
} // namespace riedel::test
