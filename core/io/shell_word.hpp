/// Texts as words of a POSIX shell.
#pragma once

#include <string>

namespace riedel {

/// One word for any text, and one line unless the text ends with a line break: unquoted if that is safe, otherwise in
/// single quotes; control characters are produced by printf from their codes.
std::string shell_word(const std::string& text);

} // namespace riedel
