/// Two discs that collide.
#pragma once

#include "apps/verify/problem.hpp"

namespace riedel {

VerifyProblem discs_problem();

} // namespace riedel
