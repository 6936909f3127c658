/// Texts from outside, made fit for messages and for files in UTF-8.
#pragma once

#include <string>
#include <string_view>

namespace riedel {

/// Length of the valid UTF-8 at the start of a text; all of it when it is valid. [bytes]
std::size_t valid_utf8(std::string_view text);

/// The text as UTF-8 on one line: U+FFFD stands for every byte that is no UTF-8, and for every control character but a
/// tab.
/// @param longest what exceeds so many bytes is left out, and "..." stands for it
std::string readable(std::string_view text, std::size_t longest = std::string_view::npos);

} // namespace riedel
