/// Completion for bash and zsh, made from the tables of commands, options and keys.
#pragma once

#include "apps/command_line.hpp"

namespace riedel {

/// The supported shells: bash, zsh.
const std::vector<std::string>& completion_shells();

/// The script, for all that comes with the program. @throws InputError for another shell
std::string completion(const std::string& shell, std::span<const Command> commands);

/// The parts of a script that do not depend on the tables: the rules common to all shells, and the link to one shell.
std::string_view completion_rules();
std::string_view completion_frontend(std::string_view shell);

} // namespace riedel
