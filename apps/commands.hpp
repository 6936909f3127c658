/// The sub-commands of the program: one line each in a table.
#pragma once

#include "apps/command_line.hpp"

namespace riedel {

int biaxial(const Arguments& arguments);
int element(const Arguments& arguments);
int list(const Arguments& arguments);
int check(const Arguments& arguments);
int bench(const Arguments& arguments);
int verify(const Arguments& arguments);
int compare(const Arguments& arguments);
int collect(const Arguments& arguments);
int reproduce(const Arguments& arguments);
int umat_check(const Arguments& arguments);

/// The words that `riedel list` knows: groups, then the names in them.
std::vector<std::string> list_words();

/// The keys of `riedel umat-check`.
Keys umat_check_keys();

const std::vector<Command>& commands();

} // namespace riedel
