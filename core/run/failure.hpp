/// Failures of a command, in words for users.
#pragma once

#include <exception>
#include <functional>
#include <string>
#include <string_view>

namespace riedel {

/// The exception's text; if memory or threads are lacking, also what to do about it.
std::string reason_of(const std::exception& error);

/// Whether a run failed because the disk is full, which says nothing about the run itself.
bool lacked_space(std::string_view reason);
/// The same for lack of disk space, memory or threads: the run may succeed at another time.
bool lacked_means(std::string_view reason);

namespace reasons { ///< parts of messages about lacking resources
constexpr const char *no_memory = "memory ran out", *too_large = "the run needs about",
                     *no_threads = "the system gives";
}

/// Rethrows the exception that is being handled: one of the program's own unchanged, any other as a RunError.
[[noreturn]] void rethrow_as_failure();

/// Runs a task that the results do not depend on, such as pictures or a report: a failure gives a warning only.
/// @param what such as "the pictures"
void try_to_write(const std::string& what, const std::function<void()>& write);

} // namespace riedel
