/// The manual page riedel(1), made from the tables of commands, options and keys.
#pragma once

#include "apps/command_line.hpp"

namespace riedel {

/// Text as roff: backslashes, dashes and leading dots are escaped, non-ASCII letters become \[uXXXX].
std::string roff(std::string_view text);

/// The whole page, for man(7). It depends only on the tables, not on the machine or its plug-ins.
/// @param day of the build, such as "2026-03-14"
std::string manual_page(std::span<const Command> commands, const std::string& day);

/// Today, or the day of SOURCE_DATE_EPOCH, which makes builds reproducible (reproducible-builds.org).
std::string day_of_build();

} // namespace riedel
