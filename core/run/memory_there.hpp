/// The memory that this process can still have.
#pragma once

#include <filesystem>
#include <string>

namespace riedel {

struct MemoryThere {
  double bytes = 0.0;
  std::string by; ///< what sets this limit, such as "the machine has left"
};

/// The least of what the machine has left, what the control groups of this process leave it (containers, batch
/// systems), and what its own limits do (ulimit -v, ulimit -d).
/// @param root where proc and sys are found
MemoryThere memory_there(const std::filesystem::path& root = "/");

/// "123 MB", "4.5 GB"
std::string bytes_text(double bytes);

} // namespace riedel
