/// The bar under a traction on its end.
#pragma once

#include "apps/verify/problem.hpp"

namespace riedel {

VerifyProblem traction_bar_problem();

} // namespace riedel
