/// Ctrl-C and `kill` as a flag that a run checks between two steps.
#pragma once

#include <array>
#include <csignal>
#include <cstdint>

namespace riedel {

/// Catches SIGINT and SIGTERM during its lifetime. A second signal ends the program at once, unless it comes within
/// half a second of the first: `timeout` and other callers send each signal twice, to the program and to its group.
class Interrupt {
public:
  Interrupt();
  ~Interrupt(); ///< restores the previous handlers
  Interrupt(const Interrupt&) = delete;
  Interrupt& operator=(const Interrupt&) = delete;

  [[nodiscard]] int signal() const; ///< the signal received, 0 if none
  [[nodiscard]] explicit operator bool() const { return signal() != 0; }
  [[nodiscard]] int exit_code() const { return 128 + signal(); } ///< 130 or 143

private:
  static constexpr std::array caught{SIGINT, SIGTERM};
  std::array<struct sigaction, caught.size()> before_{};
};

} // namespace riedel
