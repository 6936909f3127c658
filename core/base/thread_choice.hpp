/// Chooses the number of threads while the program runs. Results do not depend on the number of threads, so it may
/// change from step to step.
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

namespace riedel {

/// Range of the number of threads; if `minimum` = `maximum`, it is fixed.
struct ThreadRange {
  int minimum = 1, maximum = 1;
};

/// A monotonic clock [s].
double steady_seconds();

/// Threads that wait for each other spin, which is fast if each has a processor to itself. On a busy machine a step can
/// take a hundred times as long as on one thread, and a small case is fastest on one thread anyway. This class times
/// the steps, compares the present number with half and with twice as many for a few steps, and keeps the faster one.
/// It compares again when steps have become slow, and otherwise so rarely that comparing costs at most 2 %.
class ThreadChoice {
public:
  using Clock = std::function<double()>;
  explicit ThreadChoice(ThreadRange range, Clock clock = steady_seconds);

  /// Runs `work`, one step, on the number of threads whose turn it is.
  template <class Work>
  void step(const Work& work) {
    if (levels_.size() == 1) return work();
    begin_step();
    work();
    end_step();
  }

  [[nodiscard]] int threads() const { return levels_[choice_]; } ///< the present choice
  [[nodiscard]] int max_used() const; ///< the number used in the largest share of steps so far

private:
  /// Steps on one level, timed.
  struct Window {
    int steps = 0;
    double seconds = 0.0;
    bool warm = false; ///< the first step, which wakes threads and is not timed, is over
    void add(double step);
    [[nodiscard]] bool complete(double shortest) const;
    [[nodiscard]] double mean() const { return seconds / steps; } ///< [s]
  };
  /// Alternates between the choice and a neighbour. The better of two windows counts for each, since other load on the
  /// machine occasionally makes a window slower, never faster.
  struct Look {
    std::size_t other;  ///< level
    int windows = 0;    ///< complete windows; even ones belong to the choice
    double own, others; ///< smallest mean [s]
    double lost = 0.0;  ///< extra time over what the choice would have taken [s]
  };

  enum class Direction { fewer, more };

  void begin_step();
  void end_step();
  void watch(double step);
  void start_look(Direction direction);
  void go_on(double step);
  void decide(bool given_up);

  std::vector<int> levels_; ///< numbers of threads, each about twice the previous
  Clock clock_;
  std::vector<std::int64_t> steps_;       ///< taken on each level
  std::size_t choice_ = 0, level_ = 0;    ///< level_: that of this step
  Direction direction_ = Direction::more; ///< of the next comparison
  bool looking_ = false;
  Look look_{};
  Window window_{};
  double known_ = 0.0; ///< smallest mean of the choice in the last comparison [s]; 0: none yet
  double began_ = 0.0, next_look_ = 0.0, next_early_look_ = 0.0, interval_ = 0.0; ///< [s]
};

} // namespace riedel
