#pragma once

#include "core/interface/shape_function.hpp"

namespace riedel {

/// Adds the built-in schemes explicitly: static registrars would be dropped from archives.
template <int Dim>
void register_shape_functions(ShapeFunctions<Dim>& schemes);

} // namespace riedel
