/// Trying out code that may crash.
#pragma once

#include <functional>
#include <string>

namespace riedel {

/// Runs `work` in a copy of this process, whose memory is its own. @return how it ended early, such as "signal 11
/// (Segmentation fault)" or "exit with code 1"; empty if it returned or threw. What it writes to standard output is
/// dropped.
std::string early_end_of(const std::function<void()>& work);

} // namespace riedel
