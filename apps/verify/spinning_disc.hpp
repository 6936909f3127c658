/// A disc that spins.
#pragma once

#include "apps/verify/problem.hpp"

namespace riedel {

VerifyProblem spinning_disc_problem();

} // namespace riedel
