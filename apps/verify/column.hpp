#pragma once

#include "apps/verify/problem.hpp"

namespace riedel {

VerifyProblem column_problem();

} // namespace riedel
