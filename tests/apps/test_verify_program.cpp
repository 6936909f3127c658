/// `riedel verify` as a user runs it.
#include "apps/program.hpp"

#include <gmock/gmock.h>
#include <thread>

namespace riedel::test {
namespace {

using testing::AllOf;
using testing::ContainsRegex;
using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;

class VerifyProgram : public testing::Test {
protected:
  [[nodiscard]] Words words(const Words& more) const {
    Words all{"verify", "--problems", "bar", "--schemes", "linear,gimp", "--out", out_.string()};
    all.insert(all.end(), more.begin(), more.end());
    return all;
  }
  [[nodiscard]] std::string content(const char* name) const { return file_content(out_ / name); }

  TemporaryFolder folder_;
  std::filesystem::path out_ = folder_ / "out";
};

TEST_F(VerifyProgram, LeavesTablesNumbersAndPictures) {
  const Outcome outcome = run(folder_, words({}));
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  const std::string tables = content("verify.md"), numbers = content("verify.csv");
  EXPECT_THAT(outcome.out, AllOf(StartsWith(tables), HasSubstr("written to " + out_.string())));
  EXPECT_THAT(tables, AllOf(StartsWith("**bar**: axially vibrating bar. Relative L2 error of the velocity"),
                            HasSubstr("\n| scheme |  8 cells | 16 cells | 32 cells | order | expected | frequency | "
                                      "amplitude |   energy | "),
                            ContainsRegex("\n[|] linear [|] 3[.]54e-02 "), HasSubstr("\n| gimp ")));
  EXPECT_THAT(numbers, AllOf(StartsWith("problem,scheme,cells,error,order,expected_order,ns_per_point_step,failure"),
                             ContainsRegex("\nbar,linear,8,0[.]0354[0-9]*,1[.]4[0-9]*,1 to 2,"),
                             ContainsRegex(",frequency=-5[.]8[0-9]*e-03 amplitude=.* energy=.*\n")));
  EXPECT_EQ(std::ranges::count(numbers, '\n'), 1 + 2 * 3);
  for (const char* picture : {"convergence.png", "cost.png"}) EXPECT_THAT(content(picture), StartsWith("\x89PNG"));
}

TEST_F(VerifyProgram, WritesOverEarlierResultsWithForceAlone) {
  std::filesystem::create_directory(out_);
  folder_.file("out/verify.csv", "old");
  const Outcome refused = run(folder_, words({}));
  EXPECT_EQ(refused.code, 2);
  EXPECT_THAT(refused.err, AllOf(HasSubstr(out_.string()), HasSubstr("--force")));
  EXPECT_EQ(content("verify.csv"), "old");
  EXPECT_EQ(run(folder_, words({"--force"})).code, 0);
  EXPECT_THAT(content("verify.csv"), StartsWith("problem,"));
}

TEST_F(VerifyProgram, TakesTheNumberOfPointsInACell) {
  ASSERT_EQ(run(folder_, words({"--points", "1"})).code, 0);
  EXPECT_THAT(content("verify.md"), StartsWith("**bar**: axially vibrating bar, points per cell and axis: 1."));
  const Outcome refused = run(folder_, words({"--points", "0"}));
  EXPECT_EQ(refused.code, 2);
  EXPECT_THAT(refused.err, HasSubstr("--points 0: allowed: an integer in [1, 10]"));
}

TEST_F(VerifyProgram, RefusesUnknownNamesAndListsTheKnownOnes) {
  const Outcome scheme = run(folder_, words({"--schemes", "gim"}));
  EXPECT_EQ(scheme.code, 2);
  EXPECT_THAT(scheme.err,
              AllOf(HasSubstr("gim, is unknown (did you mean 'gimp'?)"), HasSubstr("known: linear, gimp, cpgimp")));
  const Outcome problem = run(folder_, words({"--problems", "rod"}));
  EXPECT_EQ(problem.code, 2);
  EXPECT_THAT(problem.err, AllOf(HasSubstr("rod, is unknown"), HasSubstr(" bar, "), HasSubstr(", vortex, ")));
  EXPECT_FALSE(std::filesystem::exists(out_));
}

TEST_F(VerifyProgram, PutsItsTablesIntoADocument) {
  const std::filesystem::path document =
      folder_.file("page.md", "# Title\n<!-- riedel verify -->\nold\n<!-- riedel verify ends -->\nmore\n");
  ASSERT_EQ(run(folder_, words({"--document", document.string()})).code, 0);
  EXPECT_EQ(file_content(document),
            "# Title\n<!-- riedel verify -->\n\n" + content("verify.md") + "\n<!-- riedel verify ends -->\nmore\n");
}

TEST_F(VerifyProgram, RefusesADocumentWithoutAPlaceForItsTables) {
  for (const char* text : {"", "<!-- riedel verify -->\n", "<!-- riedel verify ends -->\n<!-- riedel verify -->\n"}) {
    const std::filesystem::path document = folder_.file("page.md", text);
    const Outcome outcome = run(folder_, words({"--document", document.string()}));
    EXPECT_EQ(outcome.code, 2);
    EXPECT_THAT(outcome.err, AllOf(HasSubstr(document.string()), HasSubstr("<!-- riedel verify -->")));
    EXPECT_EQ(file_content(document), text);
  }
  EXPECT_THAT(run(folder_, words({"--document", (folder_ / "none.md").string()})).err, HasSubstr("cannot be read"));
  EXPECT_FALSE(std::filesystem::exists(out_));
}

TEST_F(VerifyProgram, EndsSoonWhenItIsInterrupted) {
  for (const auto& [signal, code] : {std::pair{SIGINT, 130}, {SIGTERM, 143}}) {
    out_ = folder_ / std::to_string(code);
    Process process(folder_, words({"--problems", "cube_crossing"}));
    while (process.running() && !std::filesystem::exists(out_))
      std::this_thread::sleep_for(std::chrono::milliseconds(10));
    std::this_thread::sleep_for(std::chrono::milliseconds(300));
    process.send(signal);
    EXPECT_EQ(process.finish(signal).code, code); // twice, as `timeout` does
    EXPECT_THAT(content("verify.csv"), Not(HasSubstr("cube_crossing,gimp,")));
  }
}

} // namespace
} // namespace riedel::test
