/// The transfers of velocities as cases name them: their parameters as keys, and what they go with.
#pragma once

#include "core/case/checked_case.hpp"
#include "core/interface/catalogue.hpp"

namespace riedel {

/// `time.NAME` for every parameter of any transfer, each once.
/// @param of_auto what "auto" means for a rate of damping
Keys transfer_keys(const Catalogue& catalogue, const std::string& of_auto);

/// The transfer that a case names.
/// @param damping in the place of "auto" for a rate [1/s]
template <int Dim>
std::shared_ptr<const VelocityTransfer<Dim>> make_transfer(const Values& values, const Catalogue& catalogue,
                                                           double damping);

/// Whether `time.transfer` goes with the scheme, with the order of the step and with the other keys.
void check_transfer(const Values& values, const Catalogue& catalogue, Diagnostics& found);

} // namespace riedel
