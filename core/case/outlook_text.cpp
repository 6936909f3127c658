#include "core/case/outlook_text.hpp"

#include "core/base/parameters.hpp"

#include <algorithm>

namespace riedel {

std::string outlook_head() { return "\n# What will run\n"; }

std::string outlook_line(const std::string& name, const std::string& text) { return "# " + name + ": " + text + "\n"; }

std::string threads_text(ThreadRange threads) {
  const std::string maximum = std::to_string(threads.maximum);
  return threads.minimum == threads.maximum
             ? maximum
             : std::to_string(threads.minimum) + " to " + maximum + ", chosen while it runs";
}

std::string product_text(const std::vector<std::int64_t>& counts) {
  std::int64_t all = 1;
  std::string factors;
  for (const std::int64_t count : counts) {
    all *= count;
    factors += (factors.empty() ? "" : " x ") + std::to_string(count);
  }
  return std::to_string(all) + " (" + factors + ")";
}

std::string span_text(double seconds) {
  constexpr double minute = 60.0, hour = 60.0 * minute, day = 24.0 * hour, year = 365.0 * day;
  if (seconds < 2.0 * minute) return short_text(std::max(seconds, 1.0), 2) + " s";
  if (seconds < 2.0 * hour) return short_text(seconds / minute, 2) + " min";
  if (seconds < 2.0 * day) return short_text(seconds / hour, 2) + " h";
  return seconds < 2.0 * year ? short_text(seconds / day, 3) + " days" : short_text(seconds / year, 2) + " years";
}

} // namespace riedel
