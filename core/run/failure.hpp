/// What goes wrong while a command works, in words for people.
#pragma once

#include <exception>
#include <functional>
#include <string>
#include <string_view>

namespace riedel {

/// The exception's text; for want of memory or of threads what to do about it.
std::string reason_of(const std::exception& error);

/// Did a run fail for want of room on a disk? That says nothing about the run itself.
bool lacked_space(std::string_view reason);
/// The same for want of room, memory or threads: the run may succeed at another time.
bool lacked_means(std::string_view reason);

namespace reasons { ///< what messages about the lack of means say
constexpr const char *no_memory = "memory ran out", *too_large = "the run needs about",
                     *no_threads = "the system gives";
}

/// Throws the exception that is being handled again: one of the program's own as it is, any other as a RunError.
[[noreturn]] void rethrow_as_failure();

/// Does what the results can do without, pictures or a report: when it fails there is a warning, and nothing else.
/// @param what such as "the pictures"
void try_to_write(const std::string& what, const std::function<void()>& write);

} // namespace riedel
