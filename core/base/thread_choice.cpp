#include "core/base/thread_choice.hpp"

#include <algorithm>
#include <chrono>
#include <limits>
#include <omp.h>
#include <utility>

namespace riedel {

namespace {

constexpr double better = 0.95;  ///< a change must bring the time below this share of the present one
constexpr double slow = 1.5;     ///< slowdown of the present choice that triggers a comparison at once
constexpr double hopeless = 4.0; ///< slowdown over the present choice at which a comparison is given up
constexpr double first_interval = 1.0, longest_interval = 30.0; ///< between comparisons [s]
constexpr double seconds_per_loss = 50.0; ///< without a comparison per second lost by the last one
constexpr int enough_steps = 10;          ///< in a window
constexpr double shortest_window = 2e-3, shortest_watch = 0.05; ///< in a comparison, and between comparisons [s]

std::vector<int> levels_of(ThreadRange range) {
  std::vector<int> levels;
  for (int threads = std::max(1, range.minimum); threads < range.maximum; threads *= 2) levels.push_back(threads);
  levels.push_back(std::max({1, range.minimum, range.maximum}));
  return levels;
}

} // namespace

double steady_seconds() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

void ThreadChoice::Window::add(double step) {
  if (!std::exchange(warm, true)) return;
  ++steps;
  seconds += step;
}

/// Long enough to be meaningful; steps of a huge case are timed one by one.
bool ThreadChoice::Window::complete(double shortest) const {
  constexpr double longest = 0.2; // [s]
  return (steps >= enough_steps && seconds >= shortest) || seconds >= longest;
}

ThreadChoice::ThreadChoice(ThreadRange range, Clock clock)
    : levels_(levels_of(range)), clock_(std::move(clock)), steps_(levels_.size(), 0), interval_(first_interval) {
  omp_set_num_threads(levels_.front());
}

int ThreadChoice::max_used() const {
  return levels_[static_cast<std::size_t>(std::ranges::max_element(steps_) - steps_.begin())];
}

void ThreadChoice::begin_step() {
  omp_set_num_threads(levels_[level_]);
  began_ = clock_();
}

void ThreadChoice::end_step() {
  const double step = clock_() - began_;
  ++steps_[level_];
  if (looking_)
    go_on(step);
  else
    watch(step);
}

/// Between comparisons: starts one if it is time.
void ThreadChoice::watch(double step) {
  window_.add(step);
  if (!window_.complete(known_ == 0.0 ? shortest_window : shortest_watch)) return;
  const double mean = window_.mean(), now = clock_();
  window_ = {.warm = true};
  const bool slowed = known_ > 0.0 && mean > slow * known_ && choice_ > 0 && now >= next_early_look_;
  if (known_ == 0.0)
    start_look(Direction::more);
  else if (slowed)
    start_look(Direction::fewer);
  else if (now >= next_look_)
    start_look(direction_);
}

void ThreadChoice::start_look(Direction direction) {
  if (choice_ == 0) direction = Direction::more;
  if (choice_ + 1 == levels_.size()) direction = Direction::fewer;
  constexpr double none = std::numeric_limits<double>::infinity();
  look_ = {.other = direction == Direction::more ? choice_ + 1 : choice_ - 1, .own = none, .others = none};
  looking_ = true;
  window_ = {.warm = true};
}

void ThreadChoice::go_on(double step) {
  constexpr int enough_windows = 4;
  const bool others_turn = level_ != choice_, wakes = !window_.warm;
  window_.add(step);
  if (others_turn) look_.lost += std::max(0.0, step - look_.own);
  const double spent = wakes ? step : window_.seconds; // waking threads is not timed, but must not take that long
  if (others_turn && spent > hopeless * std::max(enough_steps * look_.own, shortest_window)) return decide(true);
  if (!window_.complete(shortest_window)) return;
  double& minimum = others_turn ? look_.others : look_.own;
  minimum = std::min(minimum, window_.mean());
  window_ = {};
  level_ = others_turn ? choice_ : look_.other;
  if (++look_.windows == enough_windows) decide(false);
}

void ThreadChoice::decide(bool given_up) {
  const bool changes = !given_up && look_.others < better * look_.own;
  const Direction looked = look_.other > choice_ ? Direction::more : Direction::fewer;
  known_ = changes ? look_.others : look_.own;
  if (changes) choice_ = look_.other;
  level_ = choice_;
  looking_ = false;
  window_ = {};
  const bool at_end = looked == Direction::more ? choice_ + 1 == levels_.size() : choice_ == 0;
  if (changes && !at_end) return start_look(looked); // continue in the direction that pays off
  direction_ = looked == Direction::more ? Direction::fewer : Direction::more;
  interval_ = changes ? first_interval : std::min(2.0 * interval_, longest_interval);
  const double now = clock_();
  next_look_ = now + std::max(interval_, seconds_per_loss * look_.lost);
  next_early_look_ = now + std::max(0.1 * first_interval, 0.4 * seconds_per_loss * look_.lost);
}

} // namespace riedel
