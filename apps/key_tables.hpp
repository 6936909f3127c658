/// The table of keys in the forms that people and editors read.
#pragma once

#include "core/interface/catalogue.hpp"

namespace riedel {

/// Whether a scheme or law comes from a paper; "-" stands for none.
bool has_source(const Description& description);

/// What is allowed: "gimp | cpdi", "> 0", "(0, 1)", "auto | > 0", or nothing.
std::string allowed(const Key& key);

/// A table for a terminal: name, default with unit, range or choices, and what each key is.
/// @param whose keys they are, such as "with the law umat"
std::string keys_help(const Keys& keys, const std::string& whose);

/// Lines for the parameters of one scheme or law.
std::string parameters_help(const Keys& parameters);

/// The reference of all keys: of a biaxial case, with the parameters of every law, and of the element tests, as
/// Markdown.
std::string input_reference(const Catalogue& catalogue);

/// JSON Schema (draft 7) of a case. The parameters allowed in [material] follow from its model.
std::string biaxial_schema(const Catalogue& catalogue);
/// @throws InputError for an unknown test
std::string element_schema(const Catalogue& catalogue, const std::string& test);

} // namespace riedel
