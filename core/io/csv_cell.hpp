/// Texts as cells of a comma-separated file.
#pragma once

#include <string>

namespace riedel {

/// Quoted if it contains commas, quotes or line breaks. A text that a spreadsheet would take for a formula (it begins
/// with = + - @ or a tab and is not a number) is preceded by an apostrophe.
std::string csv_cell(const std::string& text);

} // namespace riedel
