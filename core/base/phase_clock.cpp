#include "core/base/phase_clock.hpp"

#include <omp.h>
#include <utility>

namespace riedel {

void PhaseClock::start() {
  seconds_.fill(0.0);
  now_ = Phase::other;
  since_ = std::chrono::steady_clock::now();
  running_ = true;
}

void PhaseClock::stop() {
  change(Phase::other);
  running_ = false;
}

bool PhaseClock::on_first_thread() { return omp_get_thread_num() == 0; }

Phase PhaseClock::change(Phase to) {
  const auto time = std::chrono::steady_clock::now();
  seconds_[static_cast<std::size_t>(now_)] += std::chrono::duration<double>(time - since_).count();
  since_ = time;
  return std::exchange(now_, to);
}

} // namespace riedel
