/// Programs that are killed at random instants. RIEDEL_KILLS is their number (tests/random_kills).
#include "apps/campaign.hpp"
#include "apps/series.hpp"
#include "support/patterns.hpp"

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>
#include <random>
#include <thread>

namespace riedel::test {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;
using Clock = std::chrono::steady_clock;

int kills() {
  constexpr int few = 6;
  const char* given = std::getenv("RIEDEL_KILLS");
  return given == nullptr ? few : std::stoi(given);
}

class RandomKills : public CampaignTest {
protected:
  /// Starts the program and kills it at some instant before, or little after, its end. @return the exit code; −1:
  /// killed
  int run_and_kill(const Words& words, std::chrono::duration<double> whole) {
    Process process(folder_, words);
    const auto instant = std::uniform_real_distribution<>(0.0, 1.2)(chance_) * whole;
    std::this_thread::sleep_for(instant);
    const std::array signals{SIGKILL, SIGTERM, SIGINT};
    return process.finish(signals[std::uniform_int_distribution<std::size_t>(0, 2)(chance_)]).code;
  }
  static std::chrono::duration<double> time_of(const std::function<void()>& work) {
    const auto start = Clock::now();
    work();
    return Clock::now() - start;
  }
  /// Files that are there are whole.
  static void expect_readable(const fs::path& folder) {
    const std::string end_of_png = "IEND\xae\x42\x60\x82";
    for (const auto& [name, text] : files_in(folder)) {
      EXPECT_TRUE(!name.ends_with(".json") || json::accept(text)) << name;
      EXPECT_TRUE(!name.ends_with(".csv") || text.empty() || text.ends_with('\n')) << name;
      EXPECT_TRUE(!name.ends_with(".png") || text.ends_with(end_of_png)) << name;
      if (!name.ends_with(".pvd")) continue;
      for (const auto& frame : read_series(folder / name))
        EXPECT_EQ(frame->data()->GetNumberOfPoints() % (8 * 28), 0) << name;
    }
  }
  /// The results of a run, without the time that it took.
  static std::string result_in(const fs::path& run) {
    json summary = json_of(run / "summary.json");
    for (const char* time : {"wall_s", "ns_per_point_step", "threads"}) summary.erase(time);
    return summary.dump() + file_content(run / "history.csv") + file_content(run / "case.toml");
  }
  static std::string status_of(const fs::path& run) {
    if (!fs::exists(run / "summary.json")) return "";
    return json_of(run / "summary.json")["status"].get<std::string>();
  }
  static bool is_done(const fs::path& run) { return status_of(run) == "done"; }
  /// The regular rows: a run that is asked to stop adds one for that moment.
  static std::string due_rows(const fs::path& run) {
    if (!fs::exists(run / "history.csv")) return "";
    const std::string rows = file_content(run / "history.csv");
    if (status_of(run) != "interrupted") return rows;
    return rows.substr(0, rows.rfind('\n', rows.size() - 2) + 1);
  }

  std::mt19937 chance_{20200917};
};

TEST_F(RandomKills, OfASingleRunLeaveReadableFilesAndAFinishedResultAlone) {
  const fs::path whole = folder_ / "whole";
  const auto time = time_of([&] { ASSERT_EQ(run(folder_, coarse_case(whole)).code, 0); });
  const std::string wanted = result_in(whole), history = file_content(whole / "history.csv");
  for (int kill = 0; kill < (kills() + 1) / 2; ++kill) {
    SCOPED_TRACE("kill " + std::to_string(kill));
    run_and_kill(coarse_case(out_, {"--force"}), time);
    if (!fs::exists(out_)) continue;
    expect_readable(out_);
    EXPECT_TRUE(history.starts_with(due_rows(out_)));
    if (!is_done(out_)) continue;
    EXPECT_EQ(result_in(out_), wanted);
    run_and_kill(coarse_case(out_), time); // without --force it is refused, and what is finished stays
    EXPECT_EQ(result_in(out_), wanted);
  }
  ASSERT_EQ(run(folder_, coarse_case(out_, {"--force"})).code, 0);
  EXPECT_EQ(result_in(out_), wanted);
  for (const auto& [name, text] : files_in(out_)) EXPECT_FALSE(name.ends_with(".part")) << name;
}

TEST_F(RandomKills, OfACampaignLoseNoFinishedRunAndItGoesOnToTheSameResults) {
  const Words words{"--schemes", "gimp,linear", "--vary", "nonlocal.length=0,6e-3", "--threads", "2"};
  const auto time = time_of([&] { ASSERT_EQ(compare(words).code, 0); });
  const Rows wanted = results();
  std::map<std::string, std::string> finished;
  for (int kill = 0; kill < kills() / 2; ++kill) {
    SCOPED_TRACE("kill " + std::to_string(kill));
    if (finished.size() == wanted.size() || kill == 0) {
      fs::remove_all(out_);
      finished.clear();
    }
    run_and_kill(all(words), time);
    if (!fs::exists(out_)) continue;
    expect_readable(out_);
    for (const auto& [run, result] : finished) EXPECT_EQ(result_in(out_ / run), result) << run;
    for (const Row& row : wanted)
      if (is_done(out_ / row.at("run"))) finished[row.at("run")] = result_in(out_ / row.at("run"));
  }
  ASSERT_EQ(compare(words).code, 0);
  EXPECT_EQ(results(), wanted);
}

} // namespace
} // namespace riedel::test
