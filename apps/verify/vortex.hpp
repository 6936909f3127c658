#pragma once

#include "apps/verify/problem.hpp"

namespace riedel {

VerifyProblem vortex_problem();

} // namespace riedel
