/// A folder for a campaign of coarse runs, and its content.
#pragma once

#include "apps/program.hpp"

#include <charconv>

namespace riedel::test {

using Row = std::map<std::string, std::string>;
using Rows = std::vector<Row>;

class CampaignTest : public testing::Test {
protected:
  /// `riedel compare` with these words on cases that take a tenth of a second.
  [[nodiscard]] Words all(const Words& more) const {
    Words words{"compare", "--out", out_.string()};
    for (const char* setting : {"grid.cells=[8,28]", "nonlocal.length=5e-3", "loading.speed=0.4",
                                "loading.ramp_time=1e-3", "loading.final_strain=0.004", "output.plots=false"})
      words.insert(words.end(), {"--set", setting});
    words.insert(words.end(), more.begin(), more.end());
    return words;
  }
  [[nodiscard]] Outcome compare(const Words& more) const { return run(folder_, all(more)); }

  /// The rows of results.csv without the columns of time and threads.
  [[nodiscard]] Rows results() const {
    std::istringstream file(file_content(out_ / "results.csv"));
    std::string line;
    std::getline(file, line);
    const std::vector<std::string> names = cells(line);
    Rows rows;
    while (std::getline(file, line)) {
      rows.emplace_back();
      const std::vector<std::string> values = cells(line);
      EXPECT_EQ(values.size(), names.size()) << line;
      for (std::size_t c = 0; c < values.size(); ++c)
        if (names[c] != "wall_s" && names[c] != "ns_per_point_step" && names[c] != "threads")
          rows.back()[names[c]] = values[c];
    }
    return rows;
  }

  [[nodiscard]] std::optional<std::filesystem::path> first_summary() const {
    std::optional<std::filesystem::path> first;
    for (const auto& [name, text] : files_in(out_))
      if (name.ends_with("summary.json") && (!first || last_write_time(out_ / name) < last_write_time(*first)))
        first = out_ / name;
    return first;
  }
  [[nodiscard]] std::size_t summaries() const {
    if (!exists(out_)) return 0;
    const auto is_summary = [](const auto& entry) { return entry.path().filename() == "summary.json"; };
    const std::filesystem::recursive_directory_iterator all_files(
        out_, std::filesystem::directory_options::skip_permission_denied);
    return static_cast<std::size_t>(std::count_if(begin(all_files), end(all_files), is_summary));
  }

  TemporaryFolder folder_;
  std::filesystem::path out_ = folder_ / "out";

private:
  /// Cells of a line, some of them in quotes.
  static std::vector<std::string> cells(const std::string& line) {
    std::vector<std::string> all(1);
    bool quoted = false;
    for (std::size_t i = 0; i < line.size(); ++i) {
      if (line[i] == '"' && quoted && i + 1 < line.size() && line[i + 1] == '"')
        all.back() += line[i++];
      else if (line[i] == '"')
        quoted = !quoted;
      else if (line[i] == ',' && !quoted)
        all.emplace_back();
      else
        all.back() += line[i];
    }
    return all;
  }
};

/// The process whose words hold this text, 0 if there is none.
inline pid_t process_with(const std::string& text) {
  for (const auto& entry : std::filesystem::directory_iterator("/proc")) {
    const std::string name = entry.path().filename().string();
    pid_t number = 0;
    if (std::from_chars(name.data(), name.data() + name.size(), number).ec != std::errc{}) continue;
    std::string words = file_content(entry.path() / "cmdline");
    std::replace(words.begin(), words.end(), '\0', ' ');
    if (words.find(text) != std::string::npos) return number;
  }
  return 0;
}

} // namespace riedel::test
