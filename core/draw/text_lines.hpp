/// Fits texts into a given width.
#pragma once

#include <string>
#include <vector>

namespace riedel {

/// The text in lines of at most that width, broken between words, and within a word only if the word alone is too wide.
/// Text beyond the maximum number of lines is replaced by "…". An empty text has no lines.
/// @param size of the font   @param width in the same unit
std::vector<std::string> lines_of(const std::string& text, double size, double width, std::size_t maximum);

/// Width of the widest line.
double widest(const std::vector<std::string>& texts, double size);

} // namespace riedel
