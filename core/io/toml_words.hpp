/// What can be told of TOML without reading it.
#pragma once

#include <string>
#include <string_view>

namespace riedel {

/// A part of a dotted name that needs no quotes: letters, digits, underscores and hyphens.
bool is_bare_word(std::string_view word);

/// Without the blank space around it.
std::string_view trimmed(std::string_view text);

/// The text with a space in place of every sign that stands in quotes, and of the quotes: signs of TOML are left, at
/// their places. What follows a quote that does not end counts as quoted, and quotes behind a # count for nothing.
std::string without_quoted(std::string_view text);

/// The same of a file: comments are as blank as texts, but for their #. Lines end where they did.
std::string without_texts(std::string_view text);

/// For a line that is no TOML: "; a text stands in quotes: \"word\"", or whatever it seems to lack. Empty when nothing
/// comes to mind.
std::string toml_hint(std::string_view line);

} // namespace riedel
