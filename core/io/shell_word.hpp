/// Texts as words of a POSIX shell.
#pragma once

#include <string>

namespace riedel {

/// One word, whatever the text holds, and one line unless the text ends with a line break: as it is where that is safe,
/// else in single quotes; with control characters as what printf makes of their numbers.
std::string shell_word(const std::string& text);

} // namespace riedel
