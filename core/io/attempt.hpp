/// Trying out code that may crash, or not come back.
#pragma once

#include <functional>
#include <string>

namespace riedel {

/// How long foreign code may take to be loaded [s]: 10, or RIEDEL_PLUGIN_TIMEOUT.
/// @throws InputError where that is no positive number
double time_for_foreign_code();

/// Runs `work` in a copy of this process, whose memory is its own. @return how it ended early, such as "crashes while
/// it is loaded: signal 11 (Segmentation fault)", "ends the program while it is loaded: exit with code 1" or "does not
/// come back while it is loaded: ended after 10 s (RIEDEL_PLUGIN_TIMEOUT)"; empty if it returned or threw. What it
/// prints is shown, on the error output, only if it ended early.
/// @param when "while it is loaded"
std::string early_end_of(const std::function<void()>& work, const std::string& when);

} // namespace riedel
