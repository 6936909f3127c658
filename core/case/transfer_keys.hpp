/// The transfers of velocities by the names that cases use, and what they go with.
#pragma once

#include "core/case/checked_case.hpp"
#include "core/interface/catalogue.hpp"
#include "core/step/model.hpp"

namespace riedel {

const std::vector<std::string>& transfer_names(); ///< flip, apic, tpic, xpic

/// Throws InputError for a name that is not among these.
VelocityTransfer transfer_named(const std::string& name);

/// Whether `time.transfer` goes with the scheme and with the other keys.
void check_transfer(const Values& values, const Catalogue& catalogue, Findings& found);

} // namespace riedel
