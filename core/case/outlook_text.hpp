/// The expected cost of running a case, as comments after the case.
#pragma once

#include "core/base/thread_choice.hpp"

#include <cstdint>
#include <string>
#include <vector>

namespace riedel {

std::string outlook_head();
std::string outlook_line(const std::string& name, const std::string& text); ///< "# name: text"

std::string threads_text(ThreadRange threads);                      ///< "1 to 4, chosen while it runs"
std::string product_text(const std::vector<std::int64_t>& factors); ///< "2016 (24 x 84)"

/// "40 s", "3.2 h", "12 days"
std::string span_text(double seconds);

} // namespace riedel
