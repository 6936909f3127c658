/// Properties of TOML texts that need no parser.
#pragma once

#include <string>
#include <string_view>

namespace riedel {

/// A part of a dotted name that needs no quotes: letters, digits, underscores and hyphens.
bool is_bare_word(std::string_view word);

/// Without surrounding blanks.
std::string_view trimmed(std::string_view text);

/// Replaces all quoted signs and the quotes by spaces: the signs of TOML remain at their positions. Everything after an
/// unclosed quote counts as quoted, and quotes after a # are ignored.
std::string without_quoted(std::string_view text);

/// The same for a file: comments are also blanked, except for their #. Line breaks are kept.
std::string without_texts(std::string_view text);

/// For a line that is not TOML: "; a text needs quotes: \"word\"", or whatever else it seems to lack; otherwise empty.
std::string toml_hint(std::string_view line);

} // namespace riedel
