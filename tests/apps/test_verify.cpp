/// `riedel verify`: the orders of convergence that each scheme promises.
#include "apps/verify/study.hpp"
#include "support/problems.hpp"

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

  static VerifyStudy refined(std::string_view name, Index most_cells) {
    VerifyStudy answer = study(problem(name), catalogue(), GetParam(), most_cells);
    EXPECT_EQ(answer.failure, "");
    return answer;
  }
};

TEST_P(VerifyTest, VibratesABarWithItsFrequencyAndWithoutLoss) {
  const VerifyStudy bar = refined("bar", 32);
  EXPECT_GT(bar.order(), bar.expected().least_order);
  EXPECT_LT(bar.runs.back().error, 0.01);
  for (const double off : bar.runs.back().figures) EXPECT_LT(std::abs(off), 2e-3); // frequency, energy
}

TEST_P(VerifyTest, ConvergesInASquareWhosePointsStayInTheirCells) {
  const VerifyStudy square = refined("square", 16);
  EXPECT_GT(square.order(), square.expected().least_order);
  EXPECT_LT(square.runs.back().error, 0.08);
}

TEST_P(VerifyTest, ConvergesInASquareWhosePointsCrossCellsIfItsAuthorsSaySo) {
  const VerifyStudy square = refined("square_crossing", 32);
  if (GetParam() == "linear") {
    EXPECT_GT(square.runs.back().error, square.runs.front().error) << "the error of crossing cells";
  } else if (GetParam() == "bspline2") { // sums over points in place of integrals: less than its second order
    EXPECT_GT(square.order(), 1.1);
    EXPECT_LT(square.runs.back().error, 0.04);
  } else {
    EXPECT_GT(square.order(), square.expected().least_order);
    EXPECT_LT(square.runs.back().error, 0.04);
  }
}

INSTANTIATE_TEST_SUITE_P(EveryScheme, VerifyTest, testing::ValuesIn(scheme_names()),
                         [](const auto& tested) { return tested.param; });

} // namespace
} // namespace riedel::test
