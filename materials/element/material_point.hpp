/// One point of a material without a grid: its deformation, and the response of its law.
#pragma once

#include "core/base/tensor.hpp"
#include "core/interface/material.hpp"

#include <functional>

namespace riedel {

/// A point and its deformation so far. Tension and extension are positive.
struct MaterialPoint {
  Mat<3> F = Mat<3>::Identity();            ///< deformation gradient
  Sym<double> strain = Sym<double>::zero(); ///< ∫ D dt, Mandel
  Sym<double> stress = Sym<double>::zero(); ///< Cauchy, Mandel [Pa]
  std::vector<double> state = {};           ///< one value per component of the law's state variables
  double time = 0.0;                        ///< [s]
  int stage = 1;                            ///< of the path that the point follows, from 1
  double stage_start = 0.0;                 ///< start of the stage [s]
  std::int64_t increments = 0;              ///< steps taken in the stage
};

/// Deforms a point by F → exp(L Δt) F, with the velocity gradient L constant over the step. As in a run, stress and
/// tensors among the state variables are rotated before the law integrates. L, rotated by half the spin, is passed in
/// the frame of the rotated tensors: this equals rotating by half the spin before and after, which is second order in
/// Δt (Strang 1968, SIAM J. Numer. Anal. 5). The law gets ‖D‖ itself, not an average.
/// @param increment L Δt [-] @param time Δt [s] @param report of the law; failures > 0: the result is invalid
/// @throws RunError if the law throws
MaterialPoint deformed(const Material& law, MaterialPoint point, const Mat<3>& increment, double time,
                       MaterialReport& report);

/// Calls `use` with a point as it would be passed to the law for that step, already rotated.
void with_batch(const Material& law, MaterialPoint point, const Mat<3>& increment, double time,
                const std::function<void(const MaterialBatch&)>& use);

/// Rotates stress and tensors among the state variables, but not F.
void rotate_tensors(const Material& law, MaterialPoint& point, const Mat<3>& Q);

/// The point's next step is the first one of the next stage.
void begin_stage(MaterialPoint& point);

/// The law's assessment of a point's state.
MaterialLimits assess(const Material& law, MaterialPoint point);

} // namespace riedel
