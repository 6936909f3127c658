/// How many threads a step takes, found out while the program runs. Results do not depend on the number of threads, so
/// it may change from step to step.
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

namespace riedel {

/// Numbers of threads that may be taken; `least` = `most`: exactly so many.
struct ThreadRange {
  int minimum = 1, maximum = 1;
};

/// Seconds on a clock that only goes forward [s].
double steady_seconds();

/// Threads that wait for each other spin, which is fast as long as each has a processor of its own. On a busy machine a
/// step can take a hundred times as long as on one thread, and a small case is fastest on one anyway. This class times
/// the steps, compares the present number with half and with twice as many for a few steps, and keeps the better one.
/// It looks again when steps have become slow and otherwise now and then, so rarely that looking costs 2 % at most.
class ThreadChoice {
public:
  using Clock = std::function<double()>;
  explicit ThreadChoice(ThreadRange range, Clock clock = steady_seconds);

  /// Does `work`, one step, on the number of threads whose turn it is.
  template <class Work>
  void step(const Work& work) {
    if (levels_.size() == 1) return work();
    begin_step();
    work();
    end_step();
  }

  [[nodiscard]] int threads() const { return levels_[choice_]; } ///< the present choice
  [[nodiscard]] int max_used() const;                            ///< by most of the steps so far

private:
  /// Steps on one level, timed.
  struct Window {
    int steps = 0;
    double seconds = 0.0;
    bool warm = false; ///< past its first step, which wakes threads and is not timed
    void add(double step);
    [[nodiscard]] bool complete(double shortest) const;
    [[nodiscard]] double mean() const { return seconds / steps; } ///< [s]
  };
  /// The choice against a neighbour, in turns; of each the better of two windows counts, as what else runs on the
  /// machine makes a window slow now and then, never fast.
  struct Look {
    std::size_t other;  ///< level
    int windows = 0;    ///< complete ones, the choice's at even numbers
    double own, others; ///< least mean [s]
    double lost = 0.0;  ///< time beyond what the choice would have taken [s]
  };

  enum class Direction { fewer, more };

  void begin_step();
  void end_step();
  void watch(double step);
  void start_look(Direction direction);
  void go_on(double step);
  void decide(bool given_up);

  std::vector<int> levels_; ///< numbers of threads, each about twice the one before
  Clock clock_;
  std::vector<std::int64_t> steps_;       ///< taken on each level
  std::size_t choice_ = 0, level_ = 0;    ///< level_: of this step
  Direction direction_ = Direction::more; ///< of the next look
  bool looking_ = false;
  Look look_{};
  Window window_{};
  double known_ = 0.0; ///< least mean of the choice at the last look [s]; 0: there was none
  double began_ = 0.0, next_look_ = 0.0, next_early_look_ = 0.0, interval_ = 0.0; ///< [s]
};

} // namespace riedel
