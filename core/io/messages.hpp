/// Messages to users, on standard error; results go to standard output and to files.
#pragma once

#include <string_view>

namespace riedel {

/// "riedel: error: ..." before every line; coloured on a terminal, unless NO_COLOR is set.
void print_error(std::string_view text);
void print_warning(std::string_view text);
void print_note(std::string_view text);

} // namespace riedel
