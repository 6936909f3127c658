/// The schemes, laws, searches and averagers that come with the program.
#pragma once

#include "core/interface/catalogue.hpp"

namespace riedel {

Catalogue full_catalogue();

} // namespace riedel
