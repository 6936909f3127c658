/// UMATs that end the program, crash, do nothing or interfere when they are loaded, and threads without copies of a
/// library.
#include "core/base/parallel.hpp"
#include "materials/umat/library.hpp"
#include "plugin/umats.hpp"

#include <atomic>
#include <chrono>
#include <csignal>
#include <thread>

namespace riedel::test {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

struct Ending {
  const char *name, *told;
};
void PrintTo(const Ending& ending, std::ostream* out) { *out << ending.name; }

class UmatThat : public testing::TestWithParam<Ending> {
protected:
  TemporaryFolder folder_;
  /// Ends in this way after `seconds`.
  [[nodiscard]] Words law(const char* seconds) const {
    return joined(umat_named("endings", GetParam().name, std::string("[") + seconds + "]"),
                  set({"material.state=[0]"}));
  }
  void expect_failure(const Outcome& outcome) {
    EXPECT_EQ(outcome.code, 3) << outcome.out;
    EXPECT_THAT(outcome.err, AllOf(HasSubstr(library("endings")), HasSubstr(GetParam().told), HasSubstr("at point "),
                                   HasSubstr("time ")));
    EXPECT_THAT(file_content(folder_ / "out" / "summary.json"),
                AllOf(HasSubstr("\"failed\""), HasSubstr(GetParam().told)));
  }
};

TEST_P(UmatThat, FailsABiaxialTestWithPointStepAndTime) {
  for (const char* threads : {"1", "2"}) {
    const Outcome outcome = run(folder_, biaxial(folder_, law("3e-4"), {"--threads", threads}));
    expect_failure(outcome);
    EXPECT_THAT(outcome.err, HasSubstr("step "));
    EXPECT_GE(read_table(folder_ / "out" / "history.csv")["step"].size(), 1U) << "what was written stays";
  }
}

TEST_P(UmatThat, FailsAnElementTestWithPointAndTimeAndKeepsItsRows) {
  const Words test = set({"loading.final_strain=0.01", "output.every_strain=1e-3"});
  for (const char* driver : {"point", "mpm"}) {
    const char* const seconds = std::string(driver) == "point" ? "0.3" : "5e-3";
    expect_failure(run(folder_, element(folder_, "triaxial", law(seconds), joined(test, {"--driver", driver}))));
    EXPECT_GT(read_table(folder_ / "out" / "element.csv")["eps_1"].size(), 1U);
  }
}

TEST_P(UmatThat, FailsTheCheckAndNamesTheProbe) {
  const Words words{"umat-check", library("endings")};
  for (const auto& [seconds, probe] :
       {std::pair{"0", "one step of the strain"}, {"0.5", "a turn and then the strain"}}) {
    const Outcome outcome = run(folder_, joined(words, law(seconds)));
    EXPECT_EQ(outcome.code, 3) << outcome.out;
    EXPECT_THAT(outcome.err, AllOf(HasSubstr(std::string("umat-check, ") + probe), HasSubstr(GetParam().told)));
  }
}

INSTANTIATE_TEST_SUITE_P(Ends, UmatThat,
                         testing::Values(Ending{"STOP", "ended the program (STOP or exit, code 0)"},
                                         Ending{"LEAVE", "ended the program (STOP or exit, code 0)"},
                                         Ending{"ABORT", "crashed: signal 6"}, Ending{"SEGV", "crashed: signal 11"},
                                         Ending{"DIVIDE", "crashed: signal 8"}, Ending{"STACK", "crashed: signal 11"}),
                         [](const auto& tested) { return std::string(tested.param.name); });

TEST(UmatInFortran, ThatStopsSaysWhyAndFailsTheRun) {
  if (!std::filesystem::exists(library("stop_umat"))) GTEST_SKIP() << "no Fortran compiler was found";
  const TemporaryFolder folder;
  const Outcome outcome = run(folder, biaxial(folder, umat_named("stop_umat", "M", "[3e-4]")));
  EXPECT_EQ(outcome.code, 3);
  EXPECT_THAT(outcome.err, AllOf(HasSubstr("friction angle out of range"), HasSubstr("ended the program (STOP"),
                                 HasSubstr("at point "), HasSubstr("step ")));
  EXPECT_THAT(outcome.out, HasSubstr("written by the UMAT"));
}

/// Faults, and the messages of the check about them.
class UmatWith : public testing::TestWithParam<Ending> {};

TEST_P(UmatWith, FailsTheCheckThatNamesTheProbe) {
  const TemporaryFolder folder;
  const Words law = umat_named("endings", GetParam().name, "[0]");
  const Outcome outcome = run(folder, joined({"umat-check", library("endings"), "--set", "material.state=[0]"}, law));
  EXPECT_EQ(outcome.code, 3) << outcome.out;
  EXPECT_THAT(outcome.err, HasSubstr(GetParam().told));
  EXPECT_THAT(outcome.out, AllOf(Not(HasSubstr("nan")), Not(HasSubstr("inf"))));
}

INSTANTIATE_TEST_SUITE_P(
    Faults, UmatWith,
    testing::Values(Ending{"NOTHING", "one step of the strain: the UMAT returned the stress that it was given"},
                    Ending{"NAN STATE",
                           "one step of the strain: the UMAT returned a state (STATEV) that is not finite"},
                    Ending{"INFINITE", "one step of the strain: the UMAT returned a stress that is not finite"},
                    Ending{"LIMP", "DDSDDE of a call without strain: the UMAT returned no stiffness"},
                    Ending{"BAD STIFFNESS", "DDSDDE of a call without strain: the UMAT returned a DDSDDE that is not"}),
    [](const auto& tested) {
      std::string name = tested.param.name;
      std::ranges::replace(name, ' ', '_');
      return name;
    });

TEST(UmatCheck, ReportsADiagnosticAmongTheStatesAndJudgesItOnlyIfItIsDeclared) {
  const TemporaryFolder folder;
  const Words words = joined({"umat-check", library("endings"), "--set", "material.state=[0]"},
                             umat_named("endings", "COUNTER", "[0]"));
  const Outcome reported = run(folder, words);
  EXPECT_EQ(reported.code, 0) << reported.err;
  EXPECT_THAT(reported.out, AllOf(HasSubstr("STATEV state_1"), HasSubstr("not judged")));
  const Outcome judged = run(folder, joined(words, set({"material.state_names=counter"})));
  EXPECT_EQ(judged.code, 3);
  EXPECT_THAT(judged.out, AllOf(HasSubstr("STATEV counter"), HasSubstr("BAD")));
}

TEST(UmatCheck, EndsAUmatThatDoesNotComeBack) {
  const TemporaryFolder folder;
  const Environment limit("RIEDEL_PLUGIN_TIMEOUT", "0.5");
  const Outcome outcome = run(folder, joined({"umat-check", library("endings"), "--set", "material.state=[0]"},
                                             umat_named("endings", "LOOP", "[0]")));
  EXPECT_EQ(outcome.code, 3);
  EXPECT_THAT(outcome.err, HasSubstr("one step of the strain: the UMAT does not come back in its first step"));
}

TEST(UmatThatIsLimp, FailsTheRunThatHasNoTimeStepFromIt) {
  const TemporaryFolder folder;
  for (const auto& [name, told] :
       {std::pair{"LIMP", "no wave speed"}, {"BAD STIFFNESS", "DDSDDE that is not finite"}}) {
    const Outcome outcome =
        run(folder, biaxial(folder, joined(umat_named("endings", name, "[0]"), set({"material.state=[0]"}))));
    EXPECT_EQ(outcome.code, 3);
    EXPECT_THAT(outcome.err, HasSubstr(told));
  }
}

class BadlyLoaded : public testing::TestWithParam<std::pair<const char*, const char*>> {};

TEST_P(BadlyLoaded, LibraryIsRefusedByItsNameWithWhatHappened) {
  const TemporaryFolder folder;
  const Environment limit("RIEDEL_PLUGIN_TIMEOUT", "0.5");
  const auto& [name, told] = GetParam();
  const bool plugin = std::string(name).starts_with("bad_");
  const Words law = plugin ? set({"material.plugin=" + library(name)}) : umat_named(name, "M", "[0]");
  std::vector<Words> commands{biaxial(folder, law), element(folder, "triaxial", law)};
  if (!plugin) commands.push_back({"umat-check", library(name)});
  for (const Words& words : commands) {
    const Outcome outcome = run(folder, words);
    EXPECT_EQ(outcome.code, 4) << words.front();
    EXPECT_THAT(outcome.err, AllOf(HasSubstr(library(name)), HasSubstr(told)));
    EXPECT_FALSE(std::filesystem::exists(folder / "out"));
  }
}

INSTANTIATE_TEST_SUITE_P(
    Kinds, BadlyLoaded,
    testing::Values(std::pair{"loading_0", "crashes while it is loaded: signal 6"},
                    std::pair{"loading_1", "does not come back while it is loaded: ended after 0.5 s"},
                    std::pair{"loading_2", "ends the program while it is loaded: exit with code 0"},
                    std::pair{"bad_7", "does not come back while it is loaded: ended after 0.5 s"},
                    std::pair{"bad_8", "ends the program while it is loaded: exit with code 0"}),
    [](const auto& tested) { return std::string(tested.param.first); });

TEST(PluginTimeout, ThatIsNoNumberIsRefused) {
  const TemporaryFolder folder;
  const Environment limit("RIEDEL_PLUGIN_TIMEOUT", "soon");
  const Outcome outcome = run(folder, biaxial(folder, umat_named("umat_0", "M", "[0]")));
  EXPECT_EQ(outcome.code, 2);
  EXPECT_THAT(outcome.err, AllOf(HasSubstr("RIEDEL_PLUGIN_TIMEOUT"), HasSubstr("soon")));
}

/// A library that closes standard output, leaves the folder, and so on: the run is that of one that does not.
TEST(LibraryThatDisturbs, LeavesTheProcessAsItWas) {
  const TemporaryFolder folder;
  std::filesystem::create_directory(folder / "here");
  const auto before = std::filesystem::current_path();
  std::filesystem::current_path(folder / "here");
  const Outcome outcome = run(folder, joined(element(folder, "triaxial", umat_named("loading_3", "M", "[0]")),
                                             {"--out", "relative", "--set", "loading.final_strain=0.01"}));
  std::filesystem::current_path(before);
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_THAT(outcome.err, HasSubstr("a banner"));
  EXPECT_EQ(outcome.err.find("a banner"), outcome.err.rfind("a banner")) << "it is printed once";
  EXPECT_THAT(outcome.out, AllOf(HasSubstr("peak"), Not(HasSubstr("a banner"))));
  EXPECT_TRUE(std::filesystem::exists(folder / "here" / "relative" / "element.csv"));
}

TEST(LibraryThatDisturbs, LeavesSignalsAndArithmetic) {
  volatile double tiny = 1e-310; // a subnormal number
  {
    const UmatLibrary loaded(library("loading_3"), "umat_", true);
    struct sigaction now {};
    sigaction(SIGTERM, nullptr, &now);
    EXPECT_NE(now.sa_handler, SIG_IGN);
  }
  EXPECT_GT(tiny * 0.5, 0.0);
}

/// If no copies can be made, threads take turns, and this is reported once.
TEST(UmatWithoutCopies, IsUsedByOneThreadAfterTheOther) {
  for (const char* place : {"/proc", "/no/such/folder"}) {
    UmatLibrary umat(library("umat_0"), "umat_", false);
    const Environment temporary("TMPDIR", place);
    testing::internal::CaptureStderr();
    std::atomic<int> inside = 0, maximum = 0;
    const auto work = [&] {
      for (int i = 0; i < 200; ++i) {
        const auto lease = umat.lease();
        maximum = std::max<int>(maximum, ++inside);
        std::this_thread::yield();
        --inside;
      }
    };
    std::thread first, second;
    {
      const auto held = umat.lease(); // so that the others certainly need a copy
      first = std::thread(work);
      second = std::thread(work);
      std::this_thread::sleep_for(std::chrono::milliseconds(20));
    }
    first.join();
    second.join();
    const std::string warning = testing::internal::GetCapturedStderr();
    if (std::string(place) != "/proc") continue; // a folder of another name serves
    EXPECT_EQ(maximum, 1);
    EXPECT_THAT(warning, AllOf(HasSubstr("threads wait for each other"), HasSubstr("/proc takes no copy")));
    EXPECT_EQ(warning.find("warning: UMAT"), warning.rfind("warning: UMAT"));
  }
}

TEST(UmatWithoutCopies, GivesTheSameOnTwoThreads) {
  const TemporaryFolder folder;
  const Words law = umat_named("motion_umats", "AGEING", "[1e7,0.3]");
  std::vector<std::string> histories;
  for (const char* threads : {"1", "2"}) {
    const Environment temporary("TMPDIR", "/proc");
    const Outcome outcome =
        run(folder, biaxial(folder, law, joined(set({"grid.cells=[16,32]"}), {"--threads", threads})));
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    histories.push_back(file_content(folder / "out" / "history.csv"));
  }
  EXPECT_EQ(histories[0], histories[1]);
}

/// A law of a plug-in that throws on any thread.
TEST(ParallelLoop, ThrowsOnWhatAThreadHasThrown) {
  for (int threads : {1, 4}) {
    omp_set_num_threads(threads);
    const auto work = [](Index i) {
      if (i % 7 == 5) throw RunError("turn " + std::to_string(i));
    };
    for (const bool unequal : {false, true}) try {
        unequal ? parallel_for_unequal(100, work) : parallel_for(100, work);
        FAIL() << "nothing was thrown";
      } catch (const RunError& error) { EXPECT_STREQ(error.what(), "turn 5"); }
  }
}

} // namespace
} // namespace riedel::test
