/// Files that a user names: read whole, or refused with the reason.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

namespace riedel {

/// Far more than a case or a table of measurements needs, and little beside a machine's memory [bytes].
inline constexpr std::uintmax_t largest_input_file = 64 << 20;

/// The bytes of a regular file. A folder, a device, a pipe or a file that is larger would be read for ever, or into all
/// of the memory.
/// @throws InputError "PATH: cannot be read: " and why
std::string read_input_file(const std::filesystem::path& path, std::uintmax_t maximum = largest_input_file);

} // namespace riedel
