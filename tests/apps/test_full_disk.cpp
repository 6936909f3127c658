/// A disk that fills at one write after another, from the first to the last of a run.
#include "apps/program.hpp"
#include "apps/series.hpp"
#include "support/patterns.hpp"

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

namespace riedel::test {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;
using testing::AllOf;
using testing::ContainsRegex;
using testing::HasSubstr;

/// The program with a replaced write(2), from a library that is loaded before all others.
class FullDisk : public testing::Test {
protected:
  void SetUp() override {
#if defined(__SANITIZE_ADDRESS__)
    GTEST_SKIP() << "sanitizers want to be loaded first";
#endif
  }
  /// @param room writes to files below the folder that succeed; all later ones find the disk full
  [[nodiscard]] Outcome run_with(int room, const Words& words) const {
    ::setenv("LD_PRELOAD", FULL_DISK_LIBRARY, 1);
    ::setenv("FULL_DISK_FOLDER", fs::canonical(folder_.path()).c_str(), 1);
    ::setenv("FULL_DISK_WRITES", std::to_string(room).c_str(), 1);
    Outcome outcome = run(folder_, words);
    ::unsetenv("LD_PRELOAD");
    return outcome;
  }
  /// What is there is whole.
  void expect_readable() const {
    for (const auto& [name, text] : files_in(out_)) {
      EXPECT_FALSE(name.ends_with(".part")) << name;
      EXPECT_TRUE(!name.ends_with(".json") || json::accept(text)) << name;
      EXPECT_TRUE(!name.ends_with(".csv") || text.empty() || text.ends_with('\n')) << name;
    }
    for (const char* index : {"points.pvd", "domains.pvd"})
      for (const auto& frame : read_series(out_ / index)) EXPECT_EQ(frame->data()->GetNumberOfPoints() > 0, true);
  }
  TemporaryFolder folder_;
  fs::path out_ = folder_ / "out";
};

TEST_F(FullDisk, EndsTheRunWithTheFilesNameUntilTheResultsAreWrittenAndCostsPicturesAfterwards) {
  Words words{"biaxial", "--out", out_.string(), "--threads", "1", "--force"};
  for (const char* setting : {"grid.cells=[4,8]", "loading.final_strain=0.001", "loading.speed=1", "nonlocal.length=0",
                              "imperfection.size=[0,0]"})
    words.insert(words.end(), {"--set", setting});
  bool was_done = false;
  for (int room = 0;; ++room) {
    ASSERT_LT(room, 100) << "the run never has enough";
    fs::remove_all(out_);
    const Outcome outcome = run_with(room, words);
    SCOPED_TRACE(std::to_string(room) + " writes: " + outcome.err);
    expect_readable();
    if (outcome.err.find("No space left") == std::string::npos) {
      EXPECT_EQ(outcome.code, 0);
      break;
    }
    EXPECT_THAT(outcome.err, ContainsRegex("cannot write " + out_.string() + "/[a-z/_.0-9]+: No space left on device"));
    EXPECT_EQ(outcome.code, was_done ? 0 : outcome.code);
    if (outcome.code == 0) {
      was_done = true;
      EXPECT_EQ(json_of(out_ / "summary.json")["status"], "done");
      EXPECT_THAT(outcome.err, AllOf(HasSubstr("warning: the pictures"), ContainsRegex("[.](png|svg): No space")));
    } else {
      EXPECT_EQ(outcome.code, 3);
      EXPECT_FALSE(fs::exists(out_ / "summary.json")) << "for which there is no room either";
    }
  }
  EXPECT_TRUE(was_done) << "a full disk was never met while pictures were drawn";
}

TEST_F(FullDisk, LeavesTheFinishedRunsOfACampaign) {
  Words words{"compare", "--out", out_.string(), "--threads", "1", "--schemes", "gimp,linear"};
  for (const char* setting : {"grid.cells=[4,8]", "loading.final_strain=0.001", "loading.speed=1", "nonlocal.length=0",
                              "imperfection.size=[0,0]", "output.plots=false", "output.vtk=false"})
    words.insert(words.end(), {"--set", setting});
  ASSERT_EQ(run(folder_, words).code, 0);
  const auto before = files_in(out_);
  for (const int room : {0, 1, 2, 3}) { // the record, the table, the report, a picture
    const Outcome outcome = run_with(room, words);
    EXPECT_EQ(outcome.code, room < 2 ? 3 : 0) << outcome.err;
    EXPECT_THAT(outcome.err, HasSubstr("No space left"));
    for (const auto& [name, text] : files_in(out_))
      EXPECT_TRUE(!name.starts_with("scheme=") || text == before.at(name)) << name;
  }
}

} // namespace
} // namespace riedel::test
