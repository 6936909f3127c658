/// The boundary conditions that come with the library.
#pragma once

#include "core/interface/boundary_condition.hpp"

namespace riedel {

template <int Dim>
void register_boundaries(BoundaryConditions<Dim>& boundaries);

} // namespace riedel
