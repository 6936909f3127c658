/// Preserves the state of the process while foreign code runs.
#pragma once

#include <array>
#include <cfenv>
#include <csignal>
#include <string>

namespace riedel {

/// Restores the processor's handling of rounding, subnormal numbers and traps on destruction: loading a library that
/// was compiled with -ffast-math changes it.
class KeptArithmetic {
public:
  KeptArithmetic() { std::fegetenv(&before_); }
  ~KeptArithmetic() { std::fesetenv(&before_); }
  KeptArithmetic(const KeptArithmetic&) = delete;
  KeptArithmetic& operator=(const KeptArithmetic&) = delete;

private:
  std::fenv_t before_{};
};

/// The same for signal handlers, the working folder, the locale and the three standard streams while a library is
/// loaded. Its standard output goes to the error output, since standard output carries results.
class Undisturbed {
public:
  Undisturbed();
  ~Undisturbed();
  Undisturbed(const Undisturbed&) = delete;
  Undisturbed& operator=(const Undisturbed&) = delete;

private:
  static constexpr int signals = 32; ///< 1 … 31
  KeptArithmetic arithmetic_;
  std::array<struct sigaction, signals> handlers_{};
  std::array<int, 3> streams_{}; ///< copies of the descriptors; −1: not open
  int folder_ = -1;
  std::string locale_;
};

} // namespace riedel
