/// Measures where the time of a step goes, for `riedel bench`; does nothing otherwise.
#pragma once

#include <array>
#include <chrono>
#include <string_view>

namespace riedel {

enum class Phase { stencils, p2g, grid, g2p, kinematics, neighbours, averaging, law, filter, sorting, other };
constexpr std::array<std::string_view, 11> phase_names{
    "stencils", "P2G", "grid", "G2P", "kinematics", "neighbours", "averaging", "law", "filter", "sorting", "other"};

/// The main thread measures, including its waits for the others at the end of loops: its phases add up to the time of a
/// step, whatever the number of threads.
class PhaseClock {
public:
  void start(); ///< from zero, in phase `other`
  void stop();
  [[nodiscard]] bool running() const { return running_; }
  [[nodiscard]] double seconds(Phase phase) const { return seconds_[static_cast<std::size_t>(phase)]; }

  /// During its lifetime, time counts for its phase; afterwards for the previous phase again.
  class Lap {
  public:
    Lap(PhaseClock& clock, Phase phase) {
      if (clock.running_ && on_first_thread()) clock_ = &clock, before_ = clock.change(phase);
    }
    ~Lap() {
      if (clock_) clock_->change(before_);
    }
    Lap(const Lap&) = delete;
    Lap& operator=(const Lap&) = delete;

  private:
    PhaseClock* clock_ = nullptr;
    Phase before_{};
  };

private:
  static bool on_first_thread();
  Phase change(Phase to); ///< @return the previous phase

  std::array<double, phase_names.size()> seconds_{};
  std::chrono::steady_clock::time_point since_{};
  Phase now_ = Phase::other;
  bool running_ = false;
};

} // namespace riedel
