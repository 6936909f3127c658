/// Progress of a run and the time left: one line that is rewritten on a terminal, otherwise one line per 10 %.
#pragma once

#include <chrono>
#include <iosfwd>
#include <string>

namespace riedel {

/// "12 s", "3 min 20 s", "2 h 05 min"
std::string duration_text(double seconds);

class Progress {
public:
  /// Writes to standard error.
  explicit Progress(std::string what);
  Progress(std::string what, std::ostream& out, bool on_terminal);
  ~Progress(); ///< ends the line
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  /// @param fraction done, 0 to 1 @param note shown after it, such as "φ = 41.2°"
  void update(double fraction, std::string_view note = {});

private:
  using Clock = std::chrono::steady_clock;

  std::string what_;
  std::ostream& out_;
  bool on_terminal_;
  bool line_open_ = false;
  int tenths_ = -1; ///< last tenth reported, if not on a terminal
  Clock::time_point start_ = Clock::now();
  Clock::time_point painted_{}; ///< when the line was last rewritten
};

} // namespace riedel
