/// Files named by a user: read whole, or refused with the reason.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

namespace riedel {

/// Far more than a case or a table of measurements needs, and small compared with a machine's memory [bytes].
inline constexpr std::uintmax_t largest_input_file = 64 << 20;

/// The bytes of a regular file. Folders, devices, pipes and larger files are refused: reading them might never end or
/// fill the memory.
/// @throws InputError "PATH: cannot be read: " and the reason
std::string read_input_file(const std::filesystem::path& path, std::uintmax_t maximum = largest_input_file);

} // namespace riedel
