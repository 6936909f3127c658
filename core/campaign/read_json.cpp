#include "core/campaign/read_json.hpp"

#include "core/base/error.hpp"
#include "core/io/input_file.hpp"

namespace riedel {

namespace {
constexpr int deepest = 16;                    ///< deep nesting would exhaust the stack of recursive readers
constexpr std::uintmax_t largest = 1ULL << 30; ///< a campaign of a hundred thousand runs [bytes]
} // namespace

nlohmann::ordered_json read_json(const std::filesystem::path& file) {
  using nlohmann::ordered_json;
  const std::string text = read_input_file(file, largest);
  const auto not_too_deep = [&](int depth, ordered_json::parse_event_t, const ordered_json&) {
    if (depth > deepest) throw InputError(file.string() + ": is nested too deeply");
    return true;
  };
  try {
    return ordered_json::parse(text, not_too_deep);
  } catch (const ordered_json::exception& error) {
    throw InputError(file.string() + ": cannot be understood: " + error.what());
  }
}

} // namespace riedel
