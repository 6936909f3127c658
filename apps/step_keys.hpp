/// The keys of the time step, which every simulation takes, and what they set.
#pragma once

#include "apps/checked_case.hpp"
#include "core/step/model.hpp"

namespace riedel {

/// `time.order`, `time.step`, `time.cfl`, `time.transfer`, `time.flip`, `time.xpic_order`, `time.objective_rate`.
Keys step_keys();

/// What these keys cannot be together.
void check_step(const Values& values, std::vector<Finding>& errors);

/// What these keys say of a model.
template <int Dim>
void set_step(Model<Dim>& model, const Values& values);

} // namespace riedel
