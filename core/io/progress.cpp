#include "core/io/progress.hpp"

#include <algorithm>
#include <cmath>
#include <iostream>
#include <unistd.h>
#include <utility>

namespace riedel {

namespace {
std::string two_digits(long number) { return (number < 10 ? "0" : "") + std::to_string(number); }
} // namespace

std::string duration_text(double seconds) {
  const long s = std::lround(std::max(seconds, 0.0));
  if (s < 60) return std::to_string(s) + " s";
  if (s < 3600) return std::to_string(s / 60) + " min " + two_digits(s % 60) + " s";
  return std::to_string(s / 3600) + " h " + two_digits(s % 3600 / 60) + " min";
}

Progress::Progress(std::string what) : Progress(std::move(what), std::cerr, ::isatty(STDERR_FILENO) == 1) {}

Progress::Progress(std::string what, std::ostream& out, bool on_terminal)
    : what_(std::move(what)), out_(out), on_terminal_(on_terminal) {}

Progress::~Progress() {
  if (line_open_) out_ << '\n' << std::flush;
}

void Progress::update(double fraction, std::string_view note) {
  constexpr auto between_paints = std::chrono::milliseconds(100);
  const double done = std::clamp(fraction, 0.0, 1.0);
  const int tenths = static_cast<int>(std::floor(done * 10.0 + 1e-9)); // 0.7 × 10 must count as 7
  const Clock::time_point now = Clock::now();
  if (on_terminal_ ? done < 1.0 && line_open_ && now - painted_ < between_paints : tenths <= tenths_) return;
  tenths_ = tenths;
  painted_ = now;

  const double elapsed = std::chrono::duration<double>(now - start_).count();
  std::string line = what_ + ": " + std::to_string(static_cast<int>(done * 100.0 + 1e-9)) + " %";
  if (done >= 1.0)
    line += ", took " + duration_text(elapsed);
  else if (done > 0.0)
    line += ", " + duration_text(elapsed * (1.0 - done) / done) + " left";
  if (!note.empty()) (line += ", ") += note;
  if (on_terminal_)
    out_ << "\r\033[K" << line << std::flush; // return to the start of the line and clear it
  else
    out_ << line << std::endl;
  line_open_ = on_terminal_;
}

} // namespace riedel
