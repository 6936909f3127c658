/// Patch tests through whole steps: motions that every scheme must reproduce exactly.
#pragma once

#include "apps/verify/measure.hpp"

namespace riedel {

/// A square or cube of one metre, linear elastic, on so many cells.
template <int Dim>
VerifySetup<Dim> make_patch(const VerifyCase& given);

/// The largest errors of all points: of velocities, F and stresses relative to their scales, of positions in cells.
/// A free body in uniform translation by nearly two cells stays free of strain and stress.
template <int Dim>
double error_of_translation(VerifySetup<Dim> setup, Watch& watch);

/// The nodes move with v = A x/T plus a constant over n steps of total time T: F = (I + A/n)ⁿ and the stress are
/// uniform.
/// @param A at most one entry in a row [-]
template <int Dim>
double error_of_linear_motion(VerifySetup<Dim> setup, const Mat<Dim>& A, Watch& watch);

VerifyProblem patch_problem();

} // namespace riedel
