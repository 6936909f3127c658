/// A run of a campaign as its folder tells it.
#pragma once

#include "core/io/table.hpp"

#include <nlohmann/json.hpp>

namespace riedel {

/// `refused`: wrong before it began; `missing`: not begun, or not come to its end; `damaged`: its files cannot be read.
enum class RunStatus { done, failed, refused, missing, damaged };
[[nodiscard]] const char* name_of(RunStatus status);

struct RunResult {
  std::string name;  ///< of its folder inside the campaign's
  std::string label; ///< for a legend
  std::vector<std::pair<std::string, std::string>> settings; ///< what it differs in from others: key, value as TOML
  std::filesystem::path folder;
  RunStatus status = RunStatus::missing;
  std::string reason{};             ///< why it is not done, in one line
  nlohmann::ordered_json summary{}; ///< summary.json; null where there is none
  Table history{};                  ///< history.csv; without columns where there is none
};

} // namespace riedel
