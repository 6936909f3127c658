/// Loops over blocks of points, distributed over threads. Blocks do not depend on the number of threads and sums are
/// taken in the order of blocks, so results are identical to the bit for any number of threads.
#pragma once

#include "core/base/types.hpp"

#include <exception>
#include <mutex>
#include <omp.h>
#include <vector>

namespace riedel {

inline int max_threads() { return omp_get_max_threads(); }
inline int this_thread() { return omp_get_thread_num(); } ///< 0 … max_threads() − 1

/// Limits the number of threads during its lifetime: for work that is too small to share.
class ThreadLimit {
public:
  explicit ThreadLimit(int maximum) : before_(max_threads()) { omp_set_num_threads(std::min(maximum, before_)); }
  ~ThreadLimit() { omp_set_num_threads(before_); }
  ThreadLimit(const ThreadLimit&) = delete;
  ThreadLimit& operator=(const ThreadLimit&) = delete;

private:
  int before_;
};

inline Index blocks_of(Index points) { return (points + block_size - 1) / block_size; }
inline Range block_range(Index block, Index points) {
  return {block * block_size, std::min((block + 1) * block_size, points)};
}

/// Exceptions thrown by threads of a loop, kept until the loop is over, since an exception that leaves it on a thread
/// ends the program. If several are thrown, that of the first iteration counts, whatever the number of threads.
class Thrown {
public:
  template <class Body>
  void guard(Index turn, const Body& body) noexcept {
    try {
      body(turn);
    } catch (...) { keep(turn); }
  }
  void rethrow() const {
    if (first_) std::rethrow_exception(first_);
  }

private:
  void keep(Index turn) noexcept {
    const std::scoped_lock lock(mutex_);
    if (first_ && turn_ < turn) return;
    first_ = std::current_exception();
    turn_ = turn;
  }
  std::mutex mutex_;
  std::exception_ptr first_;
  Index turn_ = 0;
};

/// Calls `body(i)` for i in [0, count). What a body throws is rethrown when all have finished.
template <class Body>
void parallel_for(Index count, const Body& body) {
  Thrown thrown;
#pragma omp parallel for schedule(static) if (count > 1)
  for (Index i = 0; i < count; ++i) thrown.guard(i, body);
  thrown.rethrow();
}

/// The same for bodies that take unequal times: a free thread takes the next one.
template <class Body>
void parallel_for_unequal(Index count, const Body& body) {
  Thrown thrown;
#pragma omp parallel for schedule(dynamic) if (count > 1)
  for (Index i = 0; i < count; ++i) thrown.guard(i, body);
  thrown.rethrow();
}

/// Calls `body(range)` for every block of `points` points.
template <class Body>
void for_each_block(Index points, const Body& body) {
  parallel_for(blocks_of(points), [&](Index b) { body(block_range(b, points)); });
}

/// Combines `part(range)` of all blocks, from the first to the last; `parts` is working space kept by the caller, so
/// that a step allocates nothing.
template <class T, class Part, class Combine>
T reduce_blocks(Index points, std::vector<T>& parts, T start, const Part& part, const Combine& combine) {
  parts.resize(static_cast<std::size_t>(blocks_of(points)));
  parallel_for(blocks_of(points), [&](Index b) { parts[static_cast<std::size_t>(b)] = part(block_range(b, points)); });
  for (const T& value : parts) start = combine(start, value);
  return start;
}

} // namespace riedel
