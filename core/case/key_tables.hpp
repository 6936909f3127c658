/// Tables of keys in readable form.
#pragma once

#include "core/interface/catalogue.hpp"

#include <span>

namespace riedel {

/// Whether a scheme or law comes from a paper; "-" means none.
bool has_source(const Description& description);

/// What is allowed: "one | other", "> 0", "(0, 1)", "auto | > 0", or empty.
std::string allowed(const Key& key);

/// The part of a key's name before its last word: "specimen.", or empty.
std::string section_of(const Key& key);

/// A table for a terminal: name, default with unit, range or choices, and description.
/// @param whose whose keys they are, such as "with the law NAME"
std::string keys_help(const Keys& keys, const std::string& whose);

/// Lines for the parameters of a scheme or law.
std::string parameters_help(const Keys& parameters);

/// A table in Markdown, with names without their sections.
std::string keys_markdown(const Keys& keys);
/// The same for the keys of the given sections, such as "loading.", with full names.
std::string keys_markdown(const Keys& keys, std::span<const std::string_view> sections);

} // namespace riedel
