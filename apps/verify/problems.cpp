#include "apps/verify/bar.hpp"
#include "apps/verify/column.hpp"
#include "apps/verify/cube.hpp"
#include "apps/verify/ring.hpp"
#include "apps/verify/square.hpp"
#include "apps/verify/vortex.hpp"

namespace riedel {

std::span<const VerifyProblem> verify_problems() {
  static const std::vector<VerifyProblem> all{
      bar_problem(),    still_square_problem(), crossing_square_problem(), crossing_cube_problem(), column_problem(),
      vortex_problem(), ring_problem()};
  return all;
}

} // namespace riedel
