/// The velocity transfers as named in cases: their parameters as keys, and checks of their combinations.
#pragma once

#include "core/case/checked_case.hpp"
#include "core/interface/catalogue.hpp"

namespace riedel {

/// `time.NAME` for every parameter of any transfer, once each.
/// @param of_auto meaning of "auto" for a damping rate
Keys transfer_keys(const Catalogue& catalogue, const std::string& of_auto);

/// The transfer that a case names.
/// @param damping value of "auto" for a rate [1/s]
template <int Dim>
std::shared_ptr<const VelocityTransfer<Dim>> make_transfer(const Values& values, const Catalogue& catalogue,
                                                           double damping);

/// Checks that `time.transfer` goes with the scheme, with the order of the step and with the other keys.
void check_transfer(const Values& values, const Catalogue& catalogue, Diagnostics& found);

} // namespace riedel
