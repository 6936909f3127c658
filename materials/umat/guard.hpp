/// Ways out of a UMAT other than its return: XIT, exceptions, STOP and exit, crashes.
#pragma once

#include <csetjmp>

namespace riedel {

enum class UmatEnd { returned, xit, threw, ended, crashed };

struct UmatOutcome {
  UmatEnd end = UmatEnd::returned;
  int code = 0; ///< of exit, or the signal
};

/// Where a call goes when its UMAT leaves it early, and what it then finds there.
struct UmatWayOut {
  std::jmp_buf place;
  UmatOutcome outcome;
};
/// Of the call that is under way on this thread; null: none is.
UmatWayOut*& way_out_of_umat();

/// Leaves the call that is under way on this thread, over the UMAT's frames, without running them to their ends;
/// returns where none is.
void leave_umat(UmatEnd end, int code);

/// From now on SIGSEGV, SIGBUS, SIGFPE, SIGILL and SIGABRT inside a call leave it; elsewhere they do what they did.
void catch_crashes_of_umats();
/// A stack for this thread's signal handlers, or a stack that has overflowed could not be left.
void prepare_thread_for_crashes();
/// Calls of UMATs that are under way on all threads; a UMAT's own threads may end the program, too.
class UmatCallUnderWay {
public:
  UmatCallUnderWay();
  ~UmatCallUnderWay();
  UmatCallUnderWay(const UmatCallUnderWay&) = delete;
  UmatCallUnderWay& operator=(const UmatCallUnderWay&) = delete;
};
/// Sees that the heap can still be used after a crash, which may have come while it was locked; ends the program with a
/// message and exit code 3 if not.
void try_heap_after_crash();

/// @return how the call ended
template <class Call>
UmatOutcome guarded_umat(const Call& call) {
  prepare_thread_for_crashes();
  UmatWayOut out;
  way_out_of_umat() = &out;
  if (setjmp(out.place) == 0) { // NOLINT: the only way out of Fortran
    try {
      call();
    } catch (...) { out.outcome.end = UmatEnd::threw; }
  }
  way_out_of_umat() = nullptr;
  if (out.outcome.end == UmatEnd::crashed) try_heap_after_crash();
  return out.outcome;
}

} // namespace riedel
