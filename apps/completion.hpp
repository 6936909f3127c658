/// Completion for bash and zsh, made of the tables of commands, options and keys.
#pragma once

#include "apps/command_line.hpp"

namespace riedel {

/// The shells there are: bash, zsh.
const std::vector<std::string>& completion_shells();

/// The script, for all that comes with the program. @throws InputError for another shell
std::string completion(const std::string& shell, std::span<const Command> commands);

/// The parts of a script that depend on the shell alone: what every shell runs, and what hands it to the shell.
std::string_view completion_rules();
std::string_view completion_frontend(std::string_view shell);

} // namespace riedel
