#include "apps/verify/bar.hpp"
#include "apps/verify/column.hpp"
#include "apps/verify/cube.hpp"
#include "apps/verify/discs.hpp"
#include "apps/verify/patch.hpp"
#include "apps/verify/ring.hpp"
#include "apps/verify/spinning_disc.hpp"
#include "apps/verify/square.hpp"
#include "apps/verify/traction_bar.hpp"
#include "apps/verify/vortex.hpp"

namespace riedel {

Expectation expected_across_cells(const SchemeTraits& scheme) {
  if (scheme.order_across_cells == 0) return {};
  return {"1 to 2", 1.0};
}

std::span<const VerifyProblem> verify_problems() {
  static const std::vector<VerifyProblem> all{
      patch_problem(),         bar_problem(),          traction_bar_problem(),
      column_problem(),        still_square_problem(), crossing_square_problem(),
      crossing_cube_problem(), vortex_problem(),       ring_problem(),
      discs_problem(),         spinning_disc_problem()};
  return all;
}

} // namespace riedel
