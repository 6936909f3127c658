/// Patch tests through whole steps: motions that every scheme must carry out exactly.
#pragma once

#include "apps/verify/measure.hpp"

namespace riedel {

/// A square or cube of one metre, linear elastic, on so many cells.
template <int Dim>
VerifySetup<Dim> make_patch(const VerifyCase& given);

/// The greatest errors of all points: of velocities, F and stresses over their scales, and of places in cells.
/// A free body in uniform translation by nearly two cells stays free of strain and stress.
template <int Dim>
double error_of_translation(VerifySetup<Dim> setup, Watch& watch);

/// The nodes are held in v = A x/T plus a constant over n steps, T in all: F = (I + A/n)ⁿ everywhere, and one stress.
/// @param A one entry in a row at the most [-]
template <int Dim>
double error_of_linear_motion(VerifySetup<Dim> setup, const Mat<Dim>& A, Watch& watch);

VerifyProblem patch_problem();

} // namespace riedel
