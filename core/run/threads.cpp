#include "core/run/threads.hpp"

#include "core/base/error.hpp"
#include "core/run/failure.hpp"

#include <latch>
#include <system_error>
#include <thread>
#include <vector>

namespace riedel {

/// OpenMP ends the program if it gets too few threads, so the required number is started here first, all at once.
void require_threads(int threads) {
  std::latch all_tried(1);
  std::vector<std::jthread> started;
  started.reserve(static_cast<std::size_t>(threads));
  try {
    while (static_cast<int>(started.size()) + 1 < threads) started.emplace_back([&] { all_tried.wait(); });
  } catch (const std::system_error& error) {
    all_tried.count_down();
    throw RunError(std::string(reasons::no_threads) + " " + std::to_string(1 + started.size()) + " of " +
                   std::to_string(threads) + " threads (" + error.code().message() + "); ask for fewer with --threads");
  }
  all_tried.count_down();
}

} // namespace riedel
