/// Tries out code that may crash, or not return.
#pragma once

#include <functional>
#include <string>

namespace riedel {

/// Time limit for loading foreign code [s]: 10, or RIEDEL_PLUGIN_TIMEOUT.
/// @throws InputError if that is not a positive number
double time_for_foreign_code();

/// Runs `work` in a copy of this process with its own memory. @return how it ended early, such as "crashes while it is
/// loaded: signal 11 (Segmentation fault)", "ends the program while it is loaded: exit with code 1" or "does not come
/// back while it is loaded: ended after 10 s (RIEDEL_PLUGIN_TIMEOUT)"; empty if it returned or threw. What it prints
/// goes to the error output, and only if it ended early.
/// @param when "while it is loaded"
std::string early_end_of(const std::function<void()>& work, const std::string& when);

} // namespace riedel
