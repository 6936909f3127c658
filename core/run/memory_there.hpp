/// The memory still available to this process.
#pragma once

#include <filesystem>
#include <string>

namespace riedel {

struct MemoryThere {
  double bytes = 0.0;
  std::string by; ///< what sets this limit, such as "the machine has left"
};

/// The minimum of the machine's available memory, that of the process's control groups (containers, batch systems), and
/// that of its own limits (ulimit -v, ulimit -d).
/// @param root where proc and sys are mounted
MemoryThere memory_there(const std::filesystem::path& root = "/");

/// "123 MB", "4.5 GB"
std::string bytes_text(double bytes);

} // namespace riedel
