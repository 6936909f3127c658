#include "core/base/machine.hpp"

#include "core/base/pack.hpp"

#include <fstream>

namespace riedel {

std::string instruction_set() {
  switch (detail::registers) {
  case 1:
    return "AVX-512";
  case 2:
    return "AVX";
  default:
    return "SSE";
  }
}

std::string processor_name() {
  std::ifstream file("/proc/cpuinfo");
  for (std::string line; std::getline(file, line);)
    if (line.starts_with("model name")) return line.substr(line.find(':') + 2);
  return "unknown";
}

} // namespace riedel
