/// Keeps the process as it is while foreign code does as it likes.
#pragma once

#include <array>
#include <cfenv>
#include <csignal>
#include <string>

namespace riedel {

/// What the processor does with roundings, tiny numbers and traps is again as before when it ends: a library that was
/// compiled with -ffast-math changes it by being loaded.
class KeptArithmetic {
public:
  KeptArithmetic() { std::fegetenv(&before_); }
  ~KeptArithmetic() { std::fesetenv(&before_); }
  KeptArithmetic(const KeptArithmetic&) = delete;
  KeptArithmetic& operator=(const KeptArithmetic&) = delete;

private:
  std::fenv_t before_{};
};

/// The same for signal handlers, the working folder, the locale and the three standard streams, while a library is
/// loaded. What it prints to standard output goes to the error output, since results go to the former.
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
  std::array<int, 3> streams_{}; ///< copies of the descriptors; −1: it was not open
  int folder_ = -1;
  std::string locale_;
};

} // namespace riedel
