/// Texts on schemes, laws, searches, averagers and boundary conditions, for `riedel list`.
#pragma once

#include "core/interface/catalogue.hpp"

namespace riedel {

/// An entry in a list: name, summary, source, parameters.
std::string brief_text(const Description& description);

/// A single entry, in full.
/// @param kind what it is, such as "averager"   @param key the key of a case that names it
std::string entry_text(const Description& description, const std::string& kind, const std::string& key);

/// Of a boundary condition, which a program makes.
std::string boundary_text(const Description& description);

/// The same, and in how many dimensions it is available.
std::string scheme_text(const Description& description, const Catalogue& catalogue);

/// The same, with the state variables, the variables that can be averaged and what the law asks for.
std::string law_text(const Materials::Entry& law);

} // namespace riedel
