#include "apps/interrupt.hpp"

#include <atomic>

namespace riedel {

namespace {
std::atomic<int> received = 0; // a handler has no other way to tell
static_assert(std::atomic<int>::is_always_lock_free);

extern "C" void note_signal(int signal) { received.store(signal); }
} // namespace

Interrupt::Interrupt() {
  received.store(0);
  struct sigaction action {};
  action.sa_handler = note_signal;
  action.sa_flags = SA_RESETHAND | SA_RESTART; // the second one does what it always did; system calls go on
  for (std::size_t i = 0; i < caught.size(); ++i) ::sigaction(caught[i], &action, &before_[i]);
}

Interrupt::~Interrupt() {
  for (std::size_t i = 0; i < caught.size(); ++i) ::sigaction(caught[i], &before_[i], nullptr);
}

int Interrupt::signal() const { return received.load(); }

} // namespace riedel
