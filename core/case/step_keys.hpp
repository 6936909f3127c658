/// The keys of the time step, common to all simulations, and the settings that they make.
#pragma once

#include "core/case/checked_case.hpp"
#include "core/interface/catalogue.hpp"
#include "core/step/model.hpp"

namespace riedel {

/// The values of "auto" for rates: multiples of the rate at which waves cross the specimen's width.
struct StepDefaults {
  double damping = 2.0;
  double stress_filter = 2.0;
  bool slow_damp_more = true; ///< the damping increases if loading is slow
};

/// All keys of the section `time`.
Keys step_keys(const Catalogue& catalogue, const StepDefaults& defaults = {});

/// Checks combinations of these keys.
void check_step(const Values& values, const Catalogue& catalogue, std::vector<Finding>& errors);

/// Whether the keys request the stress filter.
bool filters_stresses(const Values& values);

/// Applies these keys to a model that has its scheme.
/// @param crossing_rate at which waves cross the specimen's width at the start [1/s]
template <int Dim>
void set_step(Model<Dim>& model, const Values& values, const Catalogue& catalogue, double crossing_rate,
              const StepDefaults& defaults = {});

} // namespace riedel
