/// One point of a material without a grid: how it deforms, and what its law makes of that.
#pragma once

#include "core/base/tensor.hpp"
#include "core/interface/material.hpp"

#include <functional>

namespace riedel {

/// A point and where its deformation has brought it. Tension and extension are positive.
struct MaterialPoint {
  Mat<3> F = Mat<3>::Identity();            ///< deformation gradient
  Sym<double> strain = Sym<double>::zero(); ///< ∫ D dt, Mandel
  Sym<double> stress = Sym<double>::zero(); ///< Cauchy, Mandel [Pa]
  std::vector<double> state = {};           ///< a value per component of the law's state variables
  double time = 0.0;                        ///< [s]
  int stage = 1;                            ///< of the path that the point is led along, from 1
  double stage_start = 0.0;                 ///< when it began [s]
  std::int64_t increments = 0;              ///< steps taken in it
};

/// Deforms a point by F → exp(L Δt) F, with the velocity gradient L constant over the step. As in a run, stress and
/// tensors among the state variables are rotated before the law integrates. L, turned by half the spin, is handed over
/// in the frame that they are in then: the same as to rotate by half the spin before and after, which is second order
/// in Δt (Strang 1968, SIAM J. Numer. Anal. 5). The law sees ‖D‖ itself, not an average.
/// @param increment L Δt [-]   @param time Δt [s]   @param report of the law; failures > 0: the answer is void
/// @throws RunError where the law throws
MaterialPoint deformed(const Material& law, MaterialPoint point, const Mat<3>& increment, double time,
                       MaterialReport& report);

/// Calls `use` with a point as the law would be handed it for that step, already rotated.
void with_batch(const Material& law, MaterialPoint point, const Mat<3>& increment, double time,
                const std::function<void(const MaterialBatch&)>& use);

/// Turns stress and tensors among the state variables, but not F.
void rotate_tensors(const Material& law, MaterialPoint& point, const Mat<3>& Q);

/// The point's next step is the first one of another stage.
void begin_stage(MaterialPoint& point);

/// What the law says of a point's state.
MaterialLimits assess(const Material& law, MaterialPoint point);

} // namespace riedel
