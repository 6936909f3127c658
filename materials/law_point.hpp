/// One point of a material without a grid: how it deforms, and what its law makes of that.
#pragma once

#include "core/base/tensor.hpp"
#include "core/interface/material.hpp"

namespace riedel {

/// A point and where its deformation has brought it. Tension and extension are positive.
struct LawPoint {
  Mat<3> F = Mat<3>::Identity();            ///< deformation gradient
  Sym<double> strain = Sym<double>::zero(); ///< ∫ D dt, Mandel
  Sym<double> stress = Sym<double>::zero(); ///< Cauchy, Mandel [Pa]
  std::vector<double> state = {};           ///< a value per component of the law's state variables
  double time = 0.0;                        ///< [s]
};

/// Deforms a point by F → exp(L Δt) F, with the velocity gradient L constant over the step: stress and tensors among
/// the state variables are rotated by half the spin, the law integrates, and the other half of the rotation follows,
/// which is second order in Δt (Strang 1968, SIAM J. Numer. Anal. 5). The law sees ‖D‖ itself, not an average.
/// @param increment L Δt [-]   @param time Δt [s]   @param report of the law; failures > 0: the answer is void
LawPoint deformed(const Material& law, LawPoint point, const Mat<3>& increment, double time, MaterialReport& report);

/// What the law says of a point's state.
Survey survey(const Material& law, LawPoint point);

} // namespace riedel
