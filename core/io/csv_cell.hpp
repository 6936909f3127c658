/// Texts as cells of a comma-separated file.
#pragma once

#include <string>

namespace riedel {

/// Quoted where commas, quotes or line breaks ask for it. A text that a spreadsheet would take for a formula, one that
/// begins with = + - @ or a tab and is no number, has an apostrophe before it.
std::string csv_cell(const std::string& text);

} // namespace riedel
