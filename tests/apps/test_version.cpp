/// The version that the program reports: the commit it was built from, in every summary.
#include "apps/bench/table.hpp"
#include "apps/command_line.hpp"
#include "apps/program.hpp"
#include "apps/verify/tables.hpp"
#include "core/io/commit.hpp"
#include "support/patterns.hpp"

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

namespace riedel::test {
namespace {

using testing::ContainsRegex;
using testing::HasSubstr;
using testing::MatchesRegex;

/// An artificial source tree, and what core/io/commit.cmake reports for it.
class Commit : public testing::Test {
protected:
  void SetUp() override {
    if (!succeeds("git --version")) GTEST_SKIP() << "there is no git";
    std::filesystem::create_directories(tree_ / "apps");
    folder_.file("tree/apps/main.cpp", "int main() {}\n");
    folder_.file("tree/README.md", "one\n");
  }
  [[nodiscard]] bool succeeds(const std::string& command) const {
    return std::system((command + " >" + (folder_ / "log").string() + " 2>&1").c_str()) == 0;
  }
  void git(const std::string& words) const {
    ASSERT_TRUE(succeeds("git -C " + tree_.string() + " -c user.name=a -c user.email=a@b.c " + words)) << words;
  }
  [[nodiscard]] std::string told(const std::filesystem::path& tree) const {
    EXPECT_TRUE(succeeds(CMAKE_PROGRAM " -DSOURCE=" + tree.string() + " -DOUTPUT=" + out_.string() +
                         " -P " SOURCE_DIR "/core/io/commit.cmake"));
    const std::string source = file_content(out_), before = "return \"";
    const std::size_t start = source.find(before) + before.size();
    return source.substr(start, source.find('"', start) - start);
  }
  TemporaryFolder folder_;
  std::filesystem::path tree_ = folder_ / "tree", out_ = folder_ / "commit.cpp";
};

TEST_F(Commit, IsUnknownOutsideOfACheckoutAndInAFolderOfAnother) {
  EXPECT_EQ(told(tree_), "unknown");
  git("init");
  git("add .");
  git("commit -m first");
  EXPECT_EQ(told(tree_ / "apps"), "unknown");
}

TEST_F(Commit, IsAShortHashThatSaysWhetherTheTreeWasChanged) {
  git("init");
  git("add .");
  git("commit -m first");
  const std::string first = told(tree_);
  EXPECT_THAT(first, MatchesRegex("[0-9a-f]{7,}"));
  folder_.file("tree/README.md", "two\n");
  EXPECT_EQ(told(tree_), first + "-dirty");
  git("commit -am second");
  EXPECT_THAT(told(tree_), testing::AllOf(MatchesRegex("[0-9a-f]{7,}"), testing::Ne(first)));
  folder_.file("tree/notes.txt", "beside the sources\n");
  EXPECT_THAT(told(tree_), MatchesRegex("[0-9a-f]{7,}"));
  folder_.file("tree/apps/new.cpp", "// among the sources, and so part of the program\n");
  EXPECT_THAT(told(tree_), MatchesRegex("[0-9a-f]{7,}-dirty"));
}

TEST_F(Commit, WritesItsFileOnlyWhenTheAnswerIsAnother) {
  (void)told(tree_);
  const auto long_ago = std::filesystem::last_write_time(out_) - std::chrono::hours(1);
  std::filesystem::last_write_time(out_, long_ago);
  (void)told(tree_);
  EXPECT_EQ(std::filesystem::last_write_time(out_), long_ago);
  git("init");
  git("add .");
  git("commit -m first");
  (void)told(tree_);
  EXPECT_NE(std::filesystem::last_write_time(out_), long_ago);
}

TEST(Version, NamesTheCommit) {
  const TemporaryFolder folder;
  const std::string told = run(folder, {"--version"}).out;
  EXPECT_THAT(told, ContainsRegex("^riedel [0-9]+[.][0-9]+[.][0-9]+ [(]commit ([0-9a-f]{7,}(-dirty)?|unknown)[)]\n$"));
  EXPECT_THAT(told, HasSubstr(commit()));
  EXPECT_EQ(told, version() + "\n");
}

TEST(Version, StandsInEverySummary) {
  EXPECT_EQ(verify_summary({}, "done")["version"], version());
  EXPECT_EQ(results_json({BenchResult{}})[0]["version"], version());
  const TemporaryFolder folder;
  const std::filesystem::path out = folder / "out";
  const auto told = [&](const char* file) { return json_of(out / file)["version"]; };
  ASSERT_EQ(run(folder, {"element", "triaxial", "--set", "loading.final_strain=0.001", "--set", "output.plots=false",
                         "--out", out.string()})
                .code,
            0);
  EXPECT_EQ(told("summary.json"), version());
  const Words shorter{"--force", "--set", "output.plots=false", "--set", "loading.final_strain=0.0005"};
  ASSERT_EQ(run(folder, coarse_case(out, shorter)).code, 0);
  EXPECT_EQ(told("summary.json"), version());
}

} // namespace
} // namespace riedel::test
