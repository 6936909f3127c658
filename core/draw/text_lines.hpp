/// Texts that must not be wider than the room they have.
#pragma once

#include <string>
#include <vector>

namespace riedel {

/// The text in lines of at most that width, parted between words, and within a word only where it alone is too wide.
/// What does not fit into so many lines ends in "…". An empty text has no lines.
/// @param size of the font   @param width in the same unit
std::vector<std::string> lines_of(const std::string& text, double size, double width, std::size_t maximum);

/// Width of the widest.
double widest(const std::vector<std::string>& texts, double size);

} // namespace riedel
