/// From strain rates to stresses: non-local average, rotation, law.
#pragma once

#include "core/step/model.hpp"

namespace riedel {

constexpr int max_state_columns = 520; ///< maximum that a law may declare

/// Averages the scalar named by the law, rotates stress and tensor state with the material according to the model's
/// objective rate, and lets the law integrate the step. Throws RunError naming the first point at which the law fails.
template <int Dim>
void update_stress(State<Dim>& state, const Model<Dim>& model, double dt);

/// Largest wave speed, and number of points outside the law's bounds, of one body. @param parts working space
/// @param time at the start of the next step [s] @param step number of previous steps
template <int Dim>
MaterialLimits assess(Body<Dim>& body, std::vector<MaterialLimits>& parts, double time = 0.0, std::int64_t step = 0);

} // namespace riedel
