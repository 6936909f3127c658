/// External texts, made fit for messages and for files in UTF-8.
#pragma once

#include <string>
#include <string_view>

namespace riedel {

/// Length of the valid UTF-8 at the start of a text; its full length if it is valid. [bytes]
std::size_t valid_utf8(std::string_view text);

/// The text as UTF-8 on one line: U+FFFD replaces bytes that are not UTF-8, and control characters except tabs.
/// @param longest longer texts are cut to this many bytes and end in "..."
std::string readable(std::string_view text, std::size_t longest = std::string_view::npos);

} // namespace riedel
