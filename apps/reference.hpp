/// The reference of all keys.
#pragma once

#include "core/interface/catalogue.hpp"

namespace riedel {

/// Of a biaxial case, with the parameters of every law, and of the element tests, as Markdown.
std::string input_reference(const Catalogue& catalogue);

} // namespace riedel
