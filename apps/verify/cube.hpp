/// The axis-aligned displacement in a cube.
#pragma once

#include "apps/verify/problem.hpp"

namespace riedel {

VerifyProblem crossing_cube_problem(); ///< points cross cells

} // namespace riedel
