#include "apps/verify/square.hpp"

#include "apps/verify/axis_aligned.hpp"

namespace riedel {

namespace {

VerifyRun run_still(const VerifyCase& given) {
  return run_manufactured(given, axis_aligned_in_square(given.cells, 1e-3));
}
VerifyRun run_crossing(const VerifyCase& given) {
  return run_manufactured(given, axis_aligned_in_square(given.cells, 0.05));
}

Expectation expected_of_still(const SchemeTraits&) { return {"2", 1.5}; }
Expectation expected_of_crossing(const SchemeTraits& scheme) {
  if (scheme.order_across_cells >= 2) return {"2", 1.5};
  return expected_across_cells(scheme);
}

VerifyProblem square_problem(const std::string& name, const std::string& how) {
  return {.name = name,
          .title = "axis-aligned displacement in a unit square, " + how,
          .measure = "Relative L2 error of the displacement over one period",
          .source = "Wallstedt & Guilkey (2008)",
          .cells = {8, 16, 32},
          .figures = {},
          .run = nullptr,
          .expected = nullptr};
}

} // namespace

VerifyProblem still_square_problem() {
  VerifyProblem problem = square_problem("square", "amplitude 0.001: points stay in their cells");
  problem.run = run_still;
  problem.expected = expected_of_still;
  return problem;
}

VerifyProblem crossing_square_problem() {
  VerifyProblem problem = square_problem("square_crossing", "amplitude 0.05: points cross cells");
  problem.run = run_crossing;
  problem.expected = expected_of_crossing;
  return problem;
}

} // namespace riedel
