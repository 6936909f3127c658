/// The axis-aligned displacement in a square.
#pragma once

#include "apps/verify/problem.hpp"

namespace riedel {

VerifyProblem still_square_problem();    ///< points stay in their cells
VerifyProblem crossing_square_problem(); ///< points cross cells

} // namespace riedel
