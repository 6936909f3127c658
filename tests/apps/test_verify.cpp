/// `riedel verify`: the expected orders of convergence of each scheme.
#include "apps/verify/study.hpp"
#include "support/schemes.hpp"

#include <gtest/gtest.h>
#include <omp.h>

namespace riedel::test {
namespace {

const VerifyProblem& problem(std::string_view name) {
  for (const VerifyProblem& each : verify_problems())
    if (each.name == name) return each;
  throw std::out_of_range("no problem is called '" + std::string(name) + "'");
}

class VerifyTest : public testing::TestWithParam<std::string> {
protected:
  void SetUp() override { omp_set_num_threads(1); }
  const SchemeTraits promised_ = traits(GetParam());
  /// Gradients that are averages over neighbouring cells smooth what coarse cells can show.
  const bool smooths_ = !scheme<2>(GetParam())->gradients_follow_weights();

  static VerifyStudy refined(std::string_view name, Index max_cells) {
    VerifyStudy answer = study(problem(name), catalogue(), GetParam(), {.max_cells = max_cells});
    if (!answer.failure.empty()) throw std::runtime_error(answer.failure);
    return answer;
  }
};

TEST_P(VerifyTest, VibratesABarWithItsFrequencyAndWithoutLoss) {
  const VerifyStudy bar = refined("bar", 32);
  EXPECT_GT(bar.order(), bar.expected().min_order);
  EXPECT_LT(bar.runs.back().error, 0.01);
  for (const double off : bar.runs.back().figures) EXPECT_LT(std::abs(off), 2e-3); // frequency, amplitude, energy
}

TEST_P(VerifyTest, PassesThePatchTests) { EXPECT_EQ(refined("patch", 4).missed(), ""); }

TEST_P(VerifyTest, HasAUniformStressUnderATractionIfItsDomainsFillTheBar) {
  const VerifyStudy bar = refined("traction_bar", 8);
  EXPECT_EQ(bar.missed(), "");
  if (promised_.domain == PointDomain::none) {
    EXPECT_GT(bar.runs.back().error, 0.01) << "it does not say that it has";
  }
}

TEST_P(VerifyTest, ConvergesInASquareWhosePointsStayInTheirCells) {
  const VerifyStudy square = refined("square", 16);
  EXPECT_GT(square.order(), square.expected().min_order);
  EXPECT_LT(square.runs.back().error, 0.08);
}

TEST_P(VerifyTest, ConvergesInASquareWhosePointsCrossCellsIfItsAuthorsSaySo) {
  const VerifyStudy square = refined("square_crossing", 32);
  if (promised_.order_across_cells == 0) {
    EXPECT_GT(square.runs.back().error, square.runs.front().error) << "the error of crossing cells";
  } else { // sums over two points in place of integrals reduce a second order
    EXPECT_GT(square.order(), std::min(1.1, square.expected().min_order));
    EXPECT_LT(square.runs.back().error, 0.04);
  }
}

TEST_P(VerifyTest, ConvergesInACube) {
  const VerifyStudy cube = refined("cube_crossing", 8);
  EXPECT_GT(cube.order(), 1.0);
  EXPECT_LT(cube.runs.back().error, smooths_ ? 0.7 : 0.3);
}

TEST_P(VerifyTest, ConvergesInARingIfItSeesTheStretchAtItsFreeFaces) {
  const VerifyStudy ring = refined("ring", 16);
  if (promised_.converges_at_free_faces) {
    EXPECT_EQ(ring.missed(), "");
    EXPECT_LT(ring.runs.back().error, 6e-3);
    return;
  }
  EXPECT_LT(ring.order(), 1.0) << "it converges, and does not say so";
  if (promised_.order_across_cells == 0) {
    EXPECT_GT(ring.runs.back().error, ring.runs.front().error) << "the error of crossing cells";
  } else {
    EXPECT_LT(ring.runs[1].error, smooths_ ? 0.15 : 0.03);
  }
}

TEST_P(VerifyTest, ConvergesInAVortexWithThreePointsForACell) {
  const VerifyStudy vortex = refined("vortex", 8);
  EXPECT_GT(vortex.order(), 1.4);
  EXPECT_LT(vortex.runs.back().error, smooths_ ? 0.25 : 0.12);
}

TEST_P(VerifyTest, KeepsMomentumAndEnergyOfCollidingDiscs) {
  const VerifyRun run = refined("discs", 20).runs.back();
  EXPECT_LT(run.error, 0.01);
  EXPECT_LT(run.figures[0], 1e-14); // momentum
  EXPECT_LT(run.figures[2], -0.05) << "the discs have not met";
}

INSTANTIATE_TEST_SUITE_P(EveryScheme, VerifyTest, testing::ValuesIn(scheme_names()),
                         [](const auto& tested) { return tested.param; });

/// With two points along each axis the error of sums over points decreases more slowly, under quadratic splines with
/// order 1.3.
TEST(OrderAcrossCells, IsTheSecondWherePromisedWithFourPointsForACell) {
  omp_set_num_threads(1);
  for (const std::string& name : schemes_that([](const SchemeTraits& of) { return of.order_across_cells == 2; })) {
    const VerifyStudy square = study(problem("square_crossing"), catalogue(), name, {.points = 4});
    EXPECT_GT(square.order(), 2.0) << name;
    EXPECT_LT(square.runs.back().error, 0.012) << name;
  }
}

/// Shear moves two points per cell more than a cell apart: hats do not connect them any more.
TEST(Gimp, FallsApartInAVortexWithTwoPointsForACell) {
  omp_set_num_threads(1);
  EXPECT_NE(study(problem("vortex"), catalogue(), "gimp", {.max_cells = 8, .points = 2}).failure, "");
}

VerifyStudy study_with(Expectation (*expected)(const SchemeTraits&), const std::vector<double>& errors) {
  static VerifyProblem asked;
  asked.expected = expected;
  VerifyStudy study{.problem = &asked, .scheme = "gimp", .runs = {}, .failure = {}};
  for (const double error : errors) study.runs.push_back({.error = error});
  return study;
}

TEST(VerifyStudy, TellsWhatItLacks) {
  const auto second_order = [](const SchemeTraits&) -> Expectation { return {.text = "2", .min_order = 1.5}; };
  const auto small = [](const SchemeTraits&) -> Expectation { return {.text = "small", .max_error = 0.1}; };
  const auto nothing = [](const SchemeTraits&) -> Expectation { return {}; };
  EXPECT_EQ(study_with(second_order, {0.16, 0.04, 0.01}).missed(), "");
  EXPECT_EQ(study_with(second_order, {0.16, 0.08, 0.04}).missed(), "order 1, expected 2");
  EXPECT_EQ(study_with(small, {0.3, 0.05}).missed(), "");
  EXPECT_EQ(study_with(small, {0.05, 0.3}).missed(), "error 0.3, expected small");
  EXPECT_EQ(study_with(small, {std::nan("")}).missed(), "error nan, expected small");
  EXPECT_EQ(study_with(nothing, {0.1, 10.0}).missed(), "");
  VerifyStudy failed = study_with(small, {});
  failed.failure = "a point is lost";
  EXPECT_EQ(failed.missed(), "a point is lost, expected small");
}

} // namespace
} // namespace riedel::test
