/// Ways of leaving a UMAT other than its return: XIT, exceptions, STOP and exit, crashes.
#pragma once

#include <csetjmp>

namespace riedel {

enum class UmatEnd { returned, xit, threw, ended, crashed };

struct UmatOutcome {
  UmatEnd end = UmatEnd::returned;
  int code = 0; ///< exit code, or the signal
};

/// Where a call continues if its UMAT leaves it early, and with which outcome.
struct UmatWayOut {
  std::jmp_buf place;
  UmatOutcome outcome;
};
/// For the call in progress on this thread; null: there is none.
UmatWayOut*& way_out_of_umat();

/// Leaves the call in progress on this thread, skipping the UMAT's frames without unwinding them; returns if none is.
void leave_umat(UmatEnd end, int code);

/// From now on SIGSEGV, SIGBUS, SIGFPE, SIGILL and SIGABRT inside a call leave it; elsewhere they act as before.
void catch_crashes_of_umats();
/// Gives this thread a stack for signal handlers, without which a stack overflow could not be handled.
void prepare_thread_for_crashes();
/// Counts the calls of UMATs in progress on all threads; a UMAT's own threads may also end the program.
class UmatCallUnderWay {
public:
  UmatCallUnderWay();
  ~UmatCallUnderWay();
  UmatCallUnderWay(const UmatCallUnderWay&) = delete;
  UmatCallUnderWay& operator=(const UmatCallUnderWay&) = delete;
};
/// Checks that the heap can still be used after a crash, which may have happened while it was locked; otherwise ends
/// the program with a message and exit code 3.
void try_heap_after_crash();

/// @return how the call ended
template <class Call>
UmatOutcome guarded_umat(const Call& call) {
  prepare_thread_for_crashes();
  UmatWayOut out;
  way_out_of_umat() = &out;
  if (setjmp(out.place) == 0) { // NOLINT: the only way to leave Fortran code
    try {
      call();
    } catch (...) { out.outcome.end = UmatEnd::threw; }
  }
  way_out_of_umat() = nullptr;
  if (out.outcome.end == UmatEnd::crashed) try_heap_after_crash();
  return out.outcome;
}

} // namespace riedel
