#include "materials/umat/guard.hpp"

#include <array>
#include <atomic>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <dlfcn.h>
#include <memory>
#include <sys/syscall.h>
#include <unistd.h>
#include <vector>

namespace riedel {

namespace {

constexpr std::array crashes{SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT};
std::array<struct sigaction, crashes.size()>
    before; ///< previous actions of the signals; a handler can use nothing else
std::atomic<int> calls_under_way = 0;

template <std::size_t Size>
void say(const char (&text)[Size]) {
  if (write(STDERR_FILENO, text, Size - 1) < 0) return; // nowhere else to report
}

extern "C" void leave_crashed_umat(int signal) {
  leave_umat(UmatEnd::crashed, signal);
  for (std::size_t i = 0; i < crashes.size(); ++i)
    if (crashes[i] == signal) sigaction(signal, &before[i], nullptr);
  raise(signal); // delivered at once: it is not blocked here
}

extern "C" void give_up(int) {
  say("riedel: error: the UMAT crashed and corrupted the memory, so that nothing more can be written\n");
  syscall(SYS_exit_group, 3); // at once
}

/// The next function of this name after ours.
template <class Function>
Function next_of(const char* name) {
  return reinterpret_cast<Function>(dlsym(RTLD_NEXT, name));
}

/// A thread started by the UMAT itself has no call to leave.
void refuse_end() {
  if (calls_under_way == 0) return;
  say("riedel: error: the UMAT ended the program (STOP or exit) on a thread of its own\n");
  syscall(SYS_exit_group, 3);
}

/// @param how name of the C library's function
[[noreturn]] void end_program(const char* how, int code) {
  leave_umat(UmatEnd::ended, code);
  refuse_end();
  next_of<void (*)(int)>(how)(code);
  std::abort();
}

} // namespace

UmatWayOut*& way_out_of_umat() {
  thread_local UmatWayOut* way = nullptr;
  return way;
}

void leave_umat(UmatEnd end, int code) {
  UmatWayOut* const out = way_out_of_umat();
  if (out == nullptr) return;
  out->outcome = {end, code};
  std::longjmp(out->place, 1);
}

void catch_crashes_of_umats() {
  static std::atomic<bool> done = false;
  if (done.exchange(true)) return;
  for (std::size_t i = 0; i < crashes.size(); ++i) {
    struct sigaction action {};
    action.sa_handler = leave_crashed_umat;
    action.sa_flags = SA_ONSTACK | SA_NODEFER; // it is left by a jump, which unblocks no signal
    sigaction(crashes[i], &action, &before[i]);
  }
}

void prepare_thread_for_crashes() {
  class Stack {
  public:
    Stack() {
      stack_t now{};
      if (sigaltstack(nullptr, &now) != 0 || (now.ss_flags & SS_DISABLE) == 0) return; // set by other code
      memory_.resize(std::size_t{1} << 16);
      const stack_t own{.ss_sp = memory_.data(), .ss_flags = 0, .ss_size = memory_.size()};
      sigaltstack(&own, nullptr);
    }
    ~Stack() {
      if (memory_.empty()) return;
      stack_t none{};
      none.ss_flags = SS_DISABLE;
      sigaltstack(&none, nullptr);
    }
    Stack(const Stack&) = delete;
    Stack& operator=(const Stack&) = delete;

  private:
    std::vector<char> memory_;
  };
  thread_local const Stack stack;
  static_cast<void>(stack);
}

UmatCallUnderWay::UmatCallUnderWay() { ++calls_under_way; }
UmatCallUnderWay::~UmatCallUnderWay() { --calls_under_way; }

void try_heap_after_crash() {
  constexpr unsigned patience = 5;              // [s]; a lock left behind by the crash is never released
  constexpr std::size_t past_the_cache = 8'192; // size beyond the thread's cache, which takes no lock
  struct sigaction action {
  }, former{};
  action.sa_handler = give_up;
  sigaction(SIGALRM, &action, &former);
  const unsigned left = alarm(patience);
  std::make_unique<char[]>(past_the_cache)[0] = 'x';
  alarm(left);
  sigaction(SIGALRM, &former, nullptr);
}

} // namespace riedel

/// These precede those of the C library, so that a UMAT's STOP, which calls exit, arrives here: inside a call it ends
/// the call, elsewhere it acts as usual.
extern "C" {
__attribute__((noreturn)) void exit(int code) { riedel::end_program("exit", code); }
__attribute__((noreturn)) void _exit(int code) { riedel::end_program("_exit", code); }
__attribute__((noreturn)) void _Exit(int code) { riedel::end_program("_Exit", code); }
__attribute__((noreturn)) void quick_exit(int code) { riedel::end_program("quick_exit", code); }
}
