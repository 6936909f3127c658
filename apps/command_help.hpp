/// Texts about the commands: `--help`, and the tables that the manual uses as well.
#pragma once

#include "apps/command_line.hpp"

namespace riedel {

/// @throws InputError that names the nearest command or, for a case file in its place, the command that takes it
const Command& find_command(std::span<const Command> commands, std::string_view name);

/// @param arguments the words and settings beside `--help`, which decide on the keys shown. @throws InputError
std::string help(const Command& command, const Arguments& arguments = {});
std::string help(std::span<const Command> commands);

/// A word or number, and what it means.
struct Meaning {
  std::string name, text;
};
const std::vector<Meaning>& exit_codes();
const std::vector<Meaning>& environment_variables();
/// The files that a run writes to its folder.
const std::vector<Meaning>& result_files();
/// Command lines with what they do.
const std::vector<Meaning>& example_lines();

} // namespace riedel
