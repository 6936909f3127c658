#include "apps/verify/cube.hpp"

#include "apps/verify/axis_aligned.hpp"

namespace riedel {

namespace {

VerifyRun run_crossing(const VerifyCase& given) {
  return run_manufactured(given, axis_aligned_in_cube(given.cells, 0.05));
}

} // namespace

VerifyProblem crossing_cube_problem() {
  return {.name = "cube_crossing",
          .title = "axis-aligned displacement in a unit cube, amplitude 0.05: points cross cells",
          .measure = "Relative L2 error of the displacement over one period",
          .source = "Wallstedt & Guilkey (2008)",
          .cells = {4, 8, 16},
          .figures = {},
          .run = run_crossing,
          .expected = expected_across_cells};
}

} // namespace riedel
