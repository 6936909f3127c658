/// `riedel compare` and `riedel collect` as a user runs them.
#include "apps/campaign.hpp"

#include <gmock/gmock.h>
#include <thread>

namespace riedel::test {
namespace {

namespace fs = std::filesystem;
using testing::AllOf;
using testing::ContainsRegex;
using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;

class Compare : public CampaignTest {};

TEST_F(Compare, LeavesAFolderForEveryRunAndARowInTheTable) {
  const Outcome outcome = compare({"--schemes", "gimp,linear", "--vary", "nonlocal.length=0,6e-3"});
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  const Rows rows = results();
  ASSERT_EQ(rows.size(), 4U);
  EXPECT_EQ(rows[0].at("run"), "scheme=gimp,length=0");
  EXPECT_EQ(rows[3].at("run"), "scheme=linear,length=6e-3");
  for (const auto& row : rows) {
    EXPECT_EQ(row.at("status"), "done");
    EXPECT_EQ(row.at("reason"), "");
    EXPECT_EQ(row.at("points"), "224");
    EXPECT_THAT(row.at("phi_peak_deg"), ContainsRegex("^[0-9]+[.][0-9]+$"));
    EXPECT_EQ(row.at("band.found"), "false");
    for (const char* file : {"case.toml", "history.csv", "summary.json"})
      EXPECT_TRUE(fs::exists(out_ / row.at("run") / file)) << file;
  }
  EXPECT_EQ(rows[1].at("scheme"), "gimp");
  EXPECT_EQ(rows[1].at("nonlocal.length"), "6e-3");
  EXPECT_THAT(
      outcome.out,
      AllOf(
          HasSubstr("linear, length = 6e-3  peak "),
          HasSubstr("results.csv, report.html, curves.png, void_ratio_1.png, mean_pressure_1.png, rate_norm_1.png\n")));
  for (const char* picture : {"curves.png", "void_ratio_1.png"})
    EXPECT_THAT(file_content(out_ / picture), StartsWith("\x89PNG"));
  EXPECT_THAT(outcome.err, HasSubstr("4 of 4 runs"));
}

/// Tests at one point, and of a specimen under some schemes.
TEST_F(Compare, VariesElementTestsAsWell) {
  const std::string oedometer = folder_.file(
      "oedometer.toml", "test = \"oedometer\"\n[loading]\nfinal_strain = 0.01\nspeed = 1\n[compare]\n"
                        "title = \"Both drivers\"\nvary = [\"driver.kind=point,mpm\", \"scheme=gimp,cpdi\"]\n");
  const Outcome outcome = run(folder_, {"compare", oedometer, "--out", out_.string()});
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  const Rows rows = results();
  ASSERT_EQ(rows.size(), 4U);
  for (const auto& row : rows) {
    EXPECT_EQ(row.at("status"), "done");
    EXPECT_EQ(row.at("test"), "oedometer");
    EXPECT_GT(std::stod(row.at("sigma_1_final_Pa")), 1e4);
  }
  EXPECT_THAT(outcome.out, AllOf(ContainsRegex("peak [0-9.]+ deg at [0-9.]+ %, end "),
                                 HasSubstr("results.csv, report.html, curves.png, stress_strain.png, ")));
  EXPECT_THAT(file_content(out_ / "report.html"), AllOf(HasSubstr("Both drivers"), HasSubstr("strain ε₁ [%]")));
  const fs::path one = out_ / rows.front().at("run");
  ASSERT_EQ(
      run(folder_, {"element", "oedometer", (one / "case.toml").string(), "--out", (folder_ / "alone").string()}).code,
      0);
  EXPECT_EQ(file_content(one / "element.csv"), file_content(folder_ / "alone" / "element.csv"));
  EXPECT_THAT(run(folder_, {"collect", out_.string()}).out, HasSubstr("peak "));
}

TEST_F(Compare, RefusesToAddRunsOfAnotherKind) {
  ASSERT_EQ(run(folder_, {"compare", "--set", "test=shear", "--set", "loading.final_strain=0.01", "--vary",
                          "specimen.void_ratio=0.6,0.8", "--out", out_.string()})
                .code,
            0);
  const Outcome refused = compare({"--vary", "specimen.void_ratio=0.6,0.8"});
  EXPECT_EQ(refused.code, 2);
  EXPECT_THAT(refused.err, HasSubstr("holds another campaign"));
  EXPECT_THAT(refused.err, HasSubstr("its runs are of 'riedel element'"));
}

TEST_F(Compare, GivesARunTheSameBitsAsTheTestAlone) {
  ASSERT_EQ(compare({"--schemes", "gimp,cpdi", "--vary", "nonlocal.length=0,6e-3", "--threads", "4"}).code, 0);
  const fs::path one = out_ / "scheme=cpdi,length=6e-3";
  ASSERT_EQ(run(folder_, {"biaxial", (one / "case.toml").string(), "--out", (folder_ / "alone").string()}).code, 0);
  EXPECT_EQ(file_content(one / "history.csv"), file_content(folder_ / "alone" / "history.csv"));
}

TEST_F(Compare, ListsTheRunsWithoutStartingThem) {
  const Outcome outcome = compare({"--schemes", "gimp,cpdi", "--vary", "grid.cells=[8,28],[16,56]", "--dry-run"});
  EXPECT_EQ(outcome.code, 0);
  EXPECT_THAT(outcome.out,
              AllOf(StartsWith("4 runs"), ContainsRegex("4[0-9][.][0-9] %  scheme=cpdi,cells=[[]16,56[]]\n")));
  EXPECT_FALSE(fs::exists(out_));
}

TEST_F(Compare, TellsOfARunThatCannotBeginInItsRow) {
  const Outcome outcome = compare({"--schemes", "gimp,bspline3", "--vary", "loading.lateral=points"});
  EXPECT_EQ(outcome.code, 0);
  EXPECT_EQ(results()[0].at("status"), "done");
  EXPECT_EQ(results()[1].at("status"), "refused");
  EXPECT_THAT(results()[1].at("reason"), AllOf(HasSubstr("loading.lateral"), HasSubstr("out of balance")));
  EXPECT_EQ(results()[1].at("phi_peak_deg"), "");
}

TEST_F(Compare, TellsOfARunThatFailsInItsRow) {
  const Words blows_up{"--set", "nonlocal.length=0", "--set", "loading.final_strain=0.02"};
  Words words = blows_up;
  words.insert(words.end(), {"--vary", "time.step=auto,5e-5"});
  EXPECT_EQ(compare(words).code, 0);
  EXPECT_EQ(results()[0].at("status"), "done");
  EXPECT_EQ(results()[1].at("status"), "failed");
  EXPECT_THAT(results()[1].at("reason"), HasSubstr("step"));

  words.back() = "time.step=5e-5";
  words.push_back("--force");
  EXPECT_EQ(compare(words).code, 3) << "not one run came to its end";
}

TEST_F(Compare, SaysWhatIsWrongBeforeAnythingRuns) {
  struct Wrong {
    Words words;
    const char* message;
  };
  for (const auto& [words, message] : {
           Wrong{{"--vary", "specimen.void_rato=0.5,0.6"},
                 "--vary specimen.void_rato: unknown key (did you mean 'specimen.void_ratio'?)"},
           Wrong{{"--vary", "specimen.void_ratio="}, "expected KEY=A,B,C"},
           Wrong{{"--vary", "specimen.void_ratio=0.5,,0.6"}, "a value of the list is empty"},
           Wrong{{"--vary", "specimen.void_ratio=0.55,0.55"}, "0.55 is given twice"},
           Wrong{{"--vary", "specimen.void_ratio=0.55", "--vary", "specimen.void_ratio=0.6"}, "is varied twice"},
           Wrong{{"--schemes", ""}, "empty"},
           Wrong{{"--schemes", "gimpo"}, "--schemes gimpo: unknown (did you mean 'gimp'?)"},
           Wrong{{"--schemes", "gimp,cpid"},
                 "number 2 of the list, cpid, is unknown (did you mean 'cpdi'?); known: linear, "},
           Wrong{{"--schemes", "gimp,foo"},
                 "--schemes gimp,foo: number 2 of the list, foo, is unknown; known: linear, "},
           Wrong{{}, "nothing to compare"},
           Wrong{{"--vary", "specimen.void_ratio=0.2,0.3"}, "none of the runs can start; the first, void_ratio=0.2: "},
           Wrong{{"--schemes", "gimp", "--script", "pbs"}, "--script pbs: unknown"},
           Wrong{{"--schemes", "gimp", "--threads", "0"}, "--threads 0: allowed"},
       }) {
    const Outcome outcome = compare(words);
    EXPECT_EQ(outcome.code, 2) << message;
    EXPECT_THAT(outcome.err, HasSubstr(message));
    EXPECT_FALSE(fs::exists(out_)) << message;
  }
}

TEST_F(Compare, TakesWhatIsVariedFromTheCaseFile) {
  const fs::path study =
      folder_.file("study.toml", "scheme = \"cpdi\"\n[compare]\ntitle = \"Two schemes\"\n"
                                 "schemes = [\"gimp\", \"linear\"]\nvary = [\"nonlocal.length=0,6e-3\"]\n");
  const Outcome listed = compare({study.string(), "--vary", "nonlocal.length=0", "--dry-run"});
  EXPECT_THAT(listed.out, AllOf(StartsWith("2 runs"), HasSubstr("scheme=linear,length=0\n"), Not(HasSubstr("6e-3"))));
  EXPECT_EQ(run(folder_, {"check", study.string()}).code, 0) << "a study is a case, too";

  const fs::path wrong = folder_.file("wrong.toml", "[compare]\nscheme = [\"gimp\"]\n");
  EXPECT_THAT(compare({wrong.string()}).err,
              HasSubstr("wrong.toml:2:10: compare.scheme: unknown key (did you mean 'compare.schemes'?)"));
  const fs::path text = folder_.file("text.toml", "[compare]\nschemes = \"gimp\"\n");
  EXPECT_THAT(compare({text.string()}).err,
              HasSubstr("text.toml:2:11: compare.schemes: is \"gimp\"; allowed: a list of texts"));
}

TEST_F(Compare, RefusesAFolderThatHoldsAnotherCampaign) {
  ASSERT_EQ(compare({"--schemes", "gimp"}).code, 0);
  const auto before = files_in(out_);
  const Outcome refused = compare({"--schemes", "linear"});
  EXPECT_EQ(refused.code, 2);
  EXPECT_THAT(refused.err, AllOf(HasSubstr(out_.string()), HasSubstr("'riedel compare --out "),
                                 HasSubstr("--schemes gimp' with 1 runs"), HasSubstr("--force")));
  EXPECT_EQ(files_in(out_), before);
  EXPECT_EQ(run(folder_, coarse_case(out_)).code, 2) << "a single test must not land in it";

  ASSERT_EQ(compare({"--schemes", "linear", "--force"}).code, 0);
  EXPECT_FALSE(fs::exists(out_ / "scheme=gimp"));
  EXPECT_TRUE(fs::exists(out_ / "scheme=linear" / "summary.json"));
}

TEST_F(Compare, RefusesAFolderWithResultsOfASingleTest) {
  ASSERT_EQ(run(folder_, coarse_case(out_)).code, 0);
  EXPECT_EQ(compare({"--schemes", "gimp"}).code, 2);
}

TEST_F(Compare, TakesMoreRunsInAndKeepsThoseThatAreFinished) {
  ASSERT_EQ(compare({"--schemes", "gimp"}).code, 0);
  const auto finished = fs::last_write_time(out_ / "scheme=gimp" / "summary.json");
  ASSERT_EQ(compare({"--schemes", "linear,gimp"}).code, 0);
  EXPECT_EQ(fs::last_write_time(out_ / "scheme=gimp" / "summary.json"), finished);
  ASSERT_EQ(results().size(), 2U);
  EXPECT_EQ(results()[0].at("run"), "scheme=linear") << "in the order of the last command";
  ASSERT_EQ(compare({"--schemes", "gimp,cpdi"}).code, 0);
  ASSERT_EQ(results().size(), 3U) << "those of before stay, behind the others";
  EXPECT_EQ(results()[2].at("run"), "scheme=linear");
  for (const Row& row : results()) EXPECT_EQ(row.at("status"), "done");
}

TEST_F(Compare, RefusesToTakeInARunOfTheSameNameAndAnotherCase) {
  ASSERT_EQ(compare({"--schemes", "gimp"}).code, 0);
  const auto before = files_in(out_);
  const Outcome refused = compare({"--schemes", "gimp,linear", "--set", "specimen.void_ratio=0.6"});
  EXPECT_EQ(refused.code, 2);
  EXPECT_THAT(refused.err, HasSubstr("its run scheme=gimp has a different case"));
  EXPECT_EQ(files_in(out_), before);
}

/// Killed at any moment when a part of the runs is complete.
TEST_F(Compare, GoesOnWhereItWasKilled) {
  const Words words{"--schemes", "gimp,linear,cpdi",          "--vary",    "nonlocal.length=0,6e-3",
                    "--set",     "loading.final_strain=0.02", "--threads", "2"};
  ASSERT_EQ(compare(words).code, 0);
  const Rows whole = results();
  fs::rename(out_, folder_ / "whole");

  Process process(folder_, all(words));
  while (process.running() && summaries() < 2) std::this_thread::sleep_for(std::chrono::milliseconds(5));
  process.finish(SIGKILL);
  const std::size_t finished = summaries();
  ASSERT_THAT(finished, AllOf(testing::Ge(2U), testing::Lt(6U)));
  const auto kept = fs::last_write_time(*first_summary());
  ASSERT_EQ(compare(words).code, 0);
  EXPECT_EQ(fs::last_write_time(*first_summary()), kept) << "what was finished is not run again";
  EXPECT_EQ(results(), whole) << "but for the columns of time";
}

TEST_F(Compare, TellsOfWhatItHasWhenItIsInterrupted) {
  Process process(folder_, all({"--schemes", "gimp,linear", "--set", "loading.final_strain=0.5", "--set",
                                "loading.speed=0.01", "--threads", "1"}));
  while (process.running() && !fs::exists(out_ / "scheme=gimp" / "history.csv"))
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  std::this_thread::sleep_for(std::chrono::milliseconds(50)); // until it listens
  const Outcome outcome = process.finish(SIGINT);
  EXPECT_EQ(outcome.code, 130);
  ASSERT_EQ(results().size(), 2U);
  for (const auto& row : results()) EXPECT_EQ(row.at("status"), "missing");
  EXPECT_THAT(results()[0].at("reason"), testing::AnyOf(HasSubstr("interrupted"), HasSubstr("not run")));
  EXPECT_THAT(results()[1].at("reason"), HasSubstr("not run"));
}

TEST_F(Compare, StopsWhenTheDiskIsFullAndKeepsWhatIsFinished) {
  const Words words{"--vary", "output.vtk=false,true", "--threads", "1"};
  const Outcome outcome = run(folder_, all(words), 40'000); // the files of the second run are larger
  EXPECT_EQ(outcome.code, 3);
  EXPECT_THAT(outcome.err, AllOf(HasSubstr((out_ / "vtk=true").string()), HasSubstr("File too large"),
                                 HasSubstr("finished runs are kept")));
  const auto kept = fs::last_write_time(out_ / "vtk=false" / "summary.json");
  ASSERT_EQ(compare(words).code, 0) << "with room again it goes on";
  EXPECT_EQ(fs::last_write_time(out_ / "vtk=false" / "summary.json"), kept);
  EXPECT_EQ(results()[1].at("status"), "done");
}

TEST_F(Compare, TakesACrashForAFailure) {
  Process process(folder_, all({"--vary", "nonlocal.length=6e-3,0", "--set", "loading.final_strain=0.5", "--set",
                                "loading.speed=0.01", "--threads", "2"}));
  while (process.running() && !fs::exists(out_ / "length=0" / "history.csv"))
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  const pid_t victim = process_with("biaxial " + (out_ / "length=0" / "case.toml").string());
  ASSERT_GT(victim, 0);
  ::kill(victim, SIGABRT); // a sanitizer would catch SIGSEGV
  while (process.running() && !fs::exists(out_ / "length=0" / "summary.json"))
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  process.finish(SIGTERM);
  EXPECT_EQ(results()[1].at("status"), "failed");
  EXPECT_THAT(results()[1].at("reason"), HasSubstr("signal 6"));
}

} // namespace
} // namespace riedel::test
