/// The searches and averagers that come with the library.
#pragma once

#include "core/interface/catalogue.hpp"

namespace riedel {

template <int Dim>
void register_nonlocal(CatalogueOf<Dim>& catalogue);

} // namespace riedel
