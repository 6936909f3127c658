/// The transfers of velocities by the names that cases use.
#pragma once

#include "core/step/model.hpp"

namespace riedel {

const std::vector<std::string>& transfer_names(); ///< flip, apic, tpic, xpic

/// Throws InputError for a name that is not among these.
VelocityTransfer transfer_named(const std::string& name);

} // namespace riedel
