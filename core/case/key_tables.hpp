/// Tables of keys in the forms that people read.
#pragma once

#include "core/interface/catalogue.hpp"

#include <span>

namespace riedel {

/// Whether a scheme or law comes from a paper; "-" stands for none.
bool has_source(const Description& description);

/// What is allowed: "one | other", "> 0", "(0, 1)", "auto | > 0", or nothing.
std::string allowed(const Key& key);

/// The part of a key's name up to its last word: "specimen.", or nothing.
std::string section_of(const Key& key);

/// A table for a terminal: name, default with unit, range or choices, and what each key is.
/// @param whose keys they are, such as "with the law NAME"
std::string keys_help(const Keys& keys, const std::string& whose);

/// Lines for the parameters of one scheme or law.
std::string parameters_help(const Keys& parameters);

/// A table in Markdown, its names without their sections.
std::string keys_markdown(const Keys& keys);
/// The same of the keys in the sections named, such as "loading.", with whole names.
std::string keys_markdown(const Keys& keys, std::span<const std::string_view> sections);

} // namespace riedel
