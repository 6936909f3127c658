#pragma once

#include "apps/verify/problem.hpp"

namespace riedel {

VerifyProblem bar_problem();

} // namespace riedel
