/// The results of `riedel element`, the report of how it ended, and their folders.
#include "apps/program.hpp"
#include "core/io/table.hpp"
#include "support/patterns.hpp"

#include <chrono>
#include <gmock/gmock.h>
#include <nlohmann/json.hpp>
#include <thread>

namespace riedel::test {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;
using testing::AllOf;
using testing::HasSubstr;
using testing::StartsWith;

class ElementResults : public testing::Test {
protected:
  [[nodiscard]] Outcome element(const std::string& name, const Words& words) const {
    Words all{"element"};
    all.insert(all.end(), words.begin(), words.end());
    all.insert(all.end(), {"--out", (folder_ / name).string()});
    return run(folder_, all);
  }
  [[nodiscard]] json summary(const std::string& name) const { return json_of(folder_ / name / "summary.json"); }
  /// Cycles of shear, which lower the pressure, and a stage before them.
  [[nodiscard]] std::string cycles(int rounds, const std::string& until) const {
    return folder_.file("cycles.toml", "[specimen]\nvoid_ratio = 0.7\n[[stage]]\nsigma_1 = 80e3\nsigma_2 = 80e3\n"
                                       "sigma_3 = 80e3\n[[stage]]\nname = 'cyclic shear'\nrepeat = " +
                                           std::to_string(rounds) + "\n" + until +
                                           "eps_1 = 'hold'\neps_2 = 'hold'\neps_3 = 'hold'\n[[stage.leg]]\n"
                                           "gamma = 2e-4\n[[stage.leg]]\ngamma = -2e-4\n");
  }
  TemporaryFolder folder_;
};

TEST_F(ElementResults, RowsTellStageCycleTimeAndInvariants) {
  ASSERT_EQ(element("out", {"path", cycles(3, ""), "--set", "output.plots=false"}).code, 0);
  const riedel::Table table = read_table(folder_ / "out" / "element.csv");
  EXPECT_NEAR(table["time_s"].back(), 1.0 + 3 * 2, 1e-9);
  EXPECT_EQ(table["stage"].front(), 1.0);
  EXPECT_EQ(table["cycle"].back(), 3.0);
  for (std::size_t i = 0; i < table["stage"].size(); ++i) {
    const double s1 = table["sigma_1_Pa"][i], s2 = table["sigma_2_Pa"][i], s3 = table["sigma_3_Pa"][i];
    EXPECT_EQ(table["p_Pa"][i], (s1 + s2 + s3) / 3.0);
    EXPECT_EQ(table["q_Pa"][i], s1 - 0.5 * (s2 + s3));
    const double time = table["time_s"][i] - 1e-9;
    EXPECT_EQ(table["stage"][i], time > 1.0 ? 2.0 : 1.0) << time;
    if (time > 1.0) { EXPECT_EQ(table["cycle"][i], std::ceil(0.5 * (time - 1.0))) << time; }
  }
}

/// A long series of cycles fits into a table when fewer rows are asked for.
TEST_F(ElementResults, RowsBecomeFewerWithTheStrainBetweenThem) {
  const auto rows = [&](const std::string& every) {
    EXPECT_EQ(
        element(every, {"path", cycles(5, ""), "--set", "output.plots=false", "--set", "output.every_strain=" + every})
            .code,
        0);
    return summary(every)["rows"].get<int>();
  };
  const int usual = rows("5e-4"), few = rows("0.01");
  EXPECT_GT(usual, 100);
  EXPECT_LT(few, usual / 3);
  EXPECT_GE(few, 1 + 1 + 5 * 2) << "ends of legs are rows in any case";
}

TEST_F(ElementResults, TheReasonTellsWhichLimitEndedWhichStage) {
  ASSERT_EQ(element("out", {"path", cycles(1000, "until = 'p < 60 kPa'\n"), "--set", "output.plots=false"}).code, 0);
  const json s = summary("out");
  EXPECT_EQ(s["status"], "done");
  EXPECT_THAT(s["reason"].get<std::string>(),
              AllOf(StartsWith("stage 2 (cyclic shear), cycle "), testing::EndsWith(": ended by p < 60000.0 Pa")));
  ASSERT_EQ(element("whole", {"path", cycles(1, ""), "--set", "output.plots=false"}).code, 0);
  EXPECT_EQ(summary("whole")["reason"], "");
  ASSERT_EQ(
      element("oedometer", {"oedometer", "--set", "loading.final_stress=100e3", "--set", "output.plots=false"}).code,
      0);
  EXPECT_EQ(summary("oedometer")["reason"], "stage 1 (oedometer): ended by sigma_1 > 100000.0 Pa");
}

/// After a signal there are rows and a summary of what was reached; the last line says how far that is.
TEST_F(ElementResults, AnInterruptedPathSaysHowFarItCame) {
  Process process(folder_, {"element", "path", cycles(400000, ""), "--set", "output.plots=false", "--out",
                            (folder_ / "out").string()});
  const fs::path csv = folder_ / "out" / "element.csv";
  while (process.running() && (!fs::exists(csv) || fs::file_size(csv) < 10000))
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  const Outcome outcome = process.finish(SIGINT);
  EXPECT_EQ(outcome.code, 130);
  EXPECT_THAT(outcome.err, AllOf(HasSubstr("interrupted in stage 2 (cyclic shear), cycle "), HasSubstr("at eps_1 = ")));
  const json s = summary("out");
  EXPECT_EQ(s["status"], "interrupted");
  EXPECT_THAT(s["reason"].get<std::string>(), StartsWith("interrupted in stage 2 (cyclic shear), cycle "));
  EXPECT_EQ(read_table(csv)["gamma"].size(), s["rows"].get<std::size_t>());
}

TEST_F(ElementResults, AnInterruptedFamilySaysHowManyAreComplete) {
  Process process(folder_, {"element", "path", cycles(400000, ""), "--vary", "stage.2.repeat=1,400000,2", "--set",
                            "output.plots=false", "--out", (folder_ / "out").string()});
  const fs::path csv = folder_ / "out" / "repeat=400000" / "element.csv";
  while (process.running() && (!fs::exists(csv) || fs::file_size(csv) < 10000))
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  const Outcome outcome = process.finish(SIGINT);
  EXPECT_EQ(outcome.code, 130);
  EXPECT_THAT(outcome.err,
              AllOf(HasSubstr("interrupted at repeat = 400000 in stage 2"), HasSubstr("1 of 3 runs are complete")));
  EXPECT_EQ(summary("out/repeat=1")["status"], "done");
  EXPECT_EQ(summary("out/repeat=400000")["status"], "interrupted");
}

/// The default folder has the case file's name, so that two cases do not share one.
TEST_F(ElementResults, StandUnderTheNameOfTheCaseFile) {
  const std::string file = cycles(1, "");
  const fs::path before = fs::current_path();
  fs::current_path(folder_.path());
  const Outcome named = run(folder_, {"element", "path", file, "--set", "output.plots=false"});
  const Outcome plain = run(folder_, {"element", "oedometer", "--set", "output.plots=false"});
  fs::current_path(before);
  EXPECT_EQ(named.code, 0) << named.err;
  EXPECT_EQ(plain.code, 0) << plain.err;
  EXPECT_TRUE(fs::exists(folder_ / "results" / "element" / "cycles" / "element.csv"));
  EXPECT_TRUE(fs::exists(folder_ / "results" / "element" / "oedometer" / "element.csv"));
}

/// With --force a folder holds the results of this command, and nothing of the one before.
TEST_F(ElementResults, ForcedFamiliesAndSinglesDoNotMix) {
  const Words single{"oedometer", "--set", "output.plots=false", "--force"};
  const auto family = [&](const std::string& values) {
    Words words = single;
    words.insert(words.end(), {"--vary", "specimen.void_ratio=" + values});
    return words;
  };
  const auto names = [&] {
    std::vector<std::string> all;
    for (const auto& [name, content] : files_in(folder_ / "out")) all.push_back(name);
    return all;
  };
  ASSERT_EQ(element("out", single).code, 0);
  (void)folder_.file("out/notes.txt", "mine");
  ASSERT_EQ(element("out", family("0.6,0.7")).code, 0);
  EXPECT_THAT(names(), testing::ElementsAre("notes.txt", "void_ratio=0.6/case.toml", "void_ratio=0.6/element.csv",
                                            "void_ratio=0.6/summary.json", "void_ratio=0.7/case.toml",
                                            "void_ratio=0.7/element.csv", "void_ratio=0.7/summary.json"));
  EXPECT_THAT(element("out", {"oedometer"}).err, HasSubstr("holds results already (void_ratio=0."));
  ASSERT_EQ(element("out", family("0.8")).code, 0);
  EXPECT_THAT(names(), testing::ElementsAre("notes.txt", "void_ratio=0.8/case.toml", "void_ratio=0.8/element.csv",
                                            "void_ratio=0.8/summary.json"));
  ASSERT_EQ(element("out", single).code, 0);
  EXPECT_THAT(names(), testing::ElementsAre("case.toml", "element.csv", "notes.txt", "summary.json"));
}

/// A case that lies in the folder and is varied there stays.
TEST_F(ElementResults, ForcedFamiliesKeepTheCaseThatIsVaried) {
  ASSERT_EQ(element("out", {"oedometer", "--set", "output.plots=false"}).code, 0);
  const std::string file = (folder_ / "out" / "case.toml").string(), text = file_content(file);
  ASSERT_EQ(element("out", {"oedometer", file, "--force", "--vary", "specimen.void_ratio=0.7"}).code, 0);
  EXPECT_EQ(file_content(file), text);
  EXPECT_TRUE(fs::exists(folder_ / "out" / "void_ratio=0.7" / "case.toml"));
}

TEST_F(ElementResults, DoNotDependOnTheNumberOfThreads) {
  const auto with = [](const std::string& threads) {
    return Words{
        "biaxial", "--driver",           "mpm",       "--set", "grid.cells=3", "--set", "loading.final_strain=0.002",
        "--set",   "output.plots=false", "--threads", threads};
  };
  ASSERT_EQ(element("one", with("1")).code, 0);
  ASSERT_EQ(element("two", with("2")).code, 0);
  EXPECT_EQ(file_content(folder_ / "one" / "element.csv"), file_content(folder_ / "two" / "element.csv"));
  EXPECT_THAT(element("none", with("0")).err, HasSubstr("--threads 0: allowed"));
}

} // namespace
} // namespace riedel::test
