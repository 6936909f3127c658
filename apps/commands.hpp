/// The sub-commands of the program: a line each here and in commands.cpp.
#pragma once

#include "apps/command_line.hpp"

namespace riedel {

// Each beside its code, in a folder of the same name or in a file of this one.
Command biaxial_command();
Command element_command();
Command compare_command();
Command collect_command();
Command reproduce_command();
Command check_command();
Command list_command();
Command bench_command();
Command verify_command();
Command umat_check_command();

/// The words that `riedel list` knows: groups, then the names in them.
std::vector<std::string> list_words();

/// The keys of `riedel umat-check`.
Keys umat_check_keys();

const std::vector<Command>& commands();

} // namespace riedel
