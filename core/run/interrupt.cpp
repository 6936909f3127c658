#include "core/run/interrupt.hpp"

#include <atomic>
#include <ctime>

namespace riedel {

namespace {

constexpr std::int64_t same_wish = 500'000'000; ///< signals closer than this count as one [ns]

std::atomic<int> received = 0; // a handler can use nothing else
std::atomic<std::int64_t> received_at = 0;
static_assert(std::atomic<int>::is_always_lock_free && std::atomic<std::int64_t>::is_always_lock_free);

std::int64_t now() {
  timespec time{};
  ::clock_gettime(CLOCK_MONOTONIC, &time);
  return std::int64_t{time.tv_sec} * 1'000'000'000 + time.tv_nsec;
}

extern "C" void note_signal(int signal) {
  if (received == 0) {
    received_at = now();
    received = signal;
  } else if (now() - received_at > same_wish) {
    ::signal(signal, SIG_DFL);
    ::raise(signal); // delivered when this handler returns
  }
}

} // namespace

Interrupt::Interrupt() {
  received = 0;
  struct sigaction action {};
  action.sa_handler = note_signal;
  action.sa_flags = SA_RESTART;                                         // system calls are restarted
  for (const int signal : caught) ::sigaddset(&action.sa_mask, signal); // one at a time
  for (std::size_t i = 0; i < caught.size(); ++i) ::sigaction(caught[i], &action, &before_[i]);
}

Interrupt::~Interrupt() {
  for (std::size_t i = 0; i < caught.size(); ++i) ::sigaction(caught[i], &before_[i], nullptr);
}

int Interrupt::signal() const { return received; }

} // namespace riedel
