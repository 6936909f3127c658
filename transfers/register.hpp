/// The transfers that come with the library.
#pragma once

#include "core/interface/velocity_transfer.hpp"

namespace riedel {

template <int Dim>
void register_transfers(VelocityTransfers<Dim>& transfers);

} // namespace riedel
