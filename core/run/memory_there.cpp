#include "core/run/memory_there.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <limits>
#include <optional>
#include <sstream>
#include <sys/resource.h>
#include <vector>

namespace riedel {

namespace {

namespace fs = std::filesystem;

constexpr double kilobyte = 1024.0, endless = 1e18; ///< the absence of a limit is given as a number above any memory

/// The number after a word at the start of a line, such as "MemAvailable:".
std::optional<double> entry(const fs::path& file, const std::string& word) {
  std::ifstream lines(file);
  for (std::string line; std::getline(lines, line);) {
    std::istringstream words(line);
    std::string name;
    double number = 0.0;
    if (words >> name >> number && name == word) return number;
  }
  return std::nullopt;
}

/// The number in a file; none for "max".
std::optional<double> number_in(const fs::path& file) {
  std::ifstream stream(file);
  double number = 0.0;
  if (stream >> number && number < endless) return number;
  return std::nullopt;
}

/// File names in the two versions of control groups.
struct Group {
  const char *limit, *use, *reclaimable;
};
constexpr Group version_1{"memory.limit_in_bytes", "memory.usage_in_bytes", "total_inactive_file"};
constexpr Group version_2{"memory.max", "memory.current", "inactive_file"};

/// Folders of the control groups of this process and all their parents.
std::vector<std::pair<fs::path, Group>> groups(const fs::path& root) {
  std::vector<std::pair<fs::path, Group>> all;
  const auto add = [&](const fs::path& mount, fs::path group, const Group& version) {
    for (group = group.relative_path(); !group.empty(); group = group.parent_path())
      all.emplace_back(mount / group, version);
    all.emplace_back(mount, version);
  };
  std::ifstream lines(root / "proc/self/cgroup");
  for (std::string line; std::getline(lines, line);) { // "0::/path" or "4:memory:/path"
    const std::size_t first = line.find(':'), second = line.find(':', first + 1);
    if (second == std::string::npos) continue;
    const std::string controllers = "," + line.substr(first + 1, second - first - 1) + ",";
    if (controllers == ",,")
      add(root / "sys/fs/cgroup", line.substr(second + 1), version_2);
    else if (controllers.find(",memory,") != std::string::npos)
      add(root / "sys/fs/cgroup/memory", line.substr(second + 1), version_1);
  }
  return all;
}

std::optional<double> left_in(const fs::path& folder, const Group& group) {
  const auto limit = number_in(folder / group.limit), use = number_in(folder / group.use);
  if (!limit || !use) return std::nullopt;
  return *limit - *use + entry(folder / "memory.stat", group.reclaimable).value_or(0.0);
}

std::optional<double> left_of(int resource, const fs::path& status, const std::string& in_use) {
  rlimit limit{};
  if (::getrlimit(static_cast<__rlimit_resource>(resource), &limit) != 0 || limit.rlim_cur == RLIM_INFINITY)
    return std::nullopt;
  return static_cast<double>(limit.rlim_cur) - kilobyte * entry(status, in_use).value_or(0.0);
}

} // namespace

MemoryThere memory_there(const fs::path& root) {
  MemoryThere minimum{std::numeric_limits<double>::infinity(), "no limit is known"};
  const auto consider = [&](std::optional<double> bytes, const std::string& by) {
    if (bytes && *bytes < minimum.bytes) minimum = {std::max(*bytes, 0.0), by};
  };
  if (const auto available = entry(root / "proc/meminfo", "MemAvailable:"))
    consider(kilobyte * *available, "the machine has left");
  for (const auto& [folder, group] : groups(root)) consider(left_in(folder, group), "the control group leaves");
  const fs::path status = root / "proc/self/status";
  consider(left_of(RLIMIT_AS, status, "VmSize:"), "the limit of address space (ulimit -v) leaves");
  consider(left_of(RLIMIT_DATA, status, "VmData:"), "the limit of data (ulimit -d) leaves");
  return minimum;
}

std::string bytes_text(double bytes) {
  const bool small = bytes < 999.5e6;
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), small ? "%.0f MB" : "%.3g GB", bytes / (small ? 1e6 : 1e9));
  return text.data();
}

} // namespace riedel
