/// Plug-ins that cannot be used: each is refused by its name and with the reason, exit code 4; those that fail in a run
/// leave what was written before.
#include "plugin/plugins.hpp"

#include <gmock/gmock.h>

namespace riedel::test {
namespace {

using testing::AllOf;
using testing::HasSubstr;

struct Refusal {
  std::string path, reason;
};

class UselessLibrary : public testing::TestWithParam<Refusal> {};

TEST_P(UselessLibrary, IsRefusedWithItsReason) {
  const TemporaryFolder folder;
  const Outcome outcome = run(folder, coarse_case(folder / "out", {"--set", "material.plugin=" + GetParam().path}));
  EXPECT_EQ(outcome.code, 4);
  EXPECT_THAT(outcome.err,
              AllOf(HasSubstr("--set material.plugin: plug-in " + GetParam().path), HasSubstr(GetParam().reason)));
  EXPECT_FALSE(std::filesystem::exists(folder / "out"));
}

INSTANTIATE_TEST_SUITE_P(
    Kinds, UselessLibrary,
    testing::Values(Refusal{"/no/such/file.so", "there is no such file"},
                    Refusal{library("bad_0"), "exports no 'riedel_plugin'"},
                    Refusal{library("bad_1"), "has the binary interface 4711, and this program has 3"},
                    Refusal{library("bad_9"), "has the binary interface 2, and this program has 3; compile it "
                                              "against the headers of this program"},
                    Refusal{library("bad_2"), "was compiled for Riedel 99.1.0, and this is 0."},
                    Refusal{library("bad_3"), "was compiled by g++ 3.4"},
                    Refusal{library("bad_4"), "its 'riedel_plugin' is something else"},
                    Refusal{library("bad_5"), "undefined symbol: nobody_has_this"},
                    Refusal{library("bad_6"), "crashes while it is loaded: signal 11"},
                    Refusal{SOURCE_DIR "/README.md", "cannot be loaded: "}));

TEST(BadPlugin, WithANameThatIsTakenIsRefused) {
  Catalogue all = catalogue_with(library("bad_laws"));
  try {
    load_plugin(library("bad_laws_again"), all);
    FAIL() << "accepted";
  } catch (const PluginError& error) {
    EXPECT_THAT(error.what(), AllOf(HasSubstr(library("bad_laws_again")), HasSubstr("'throws'")));
  }
}

/// A coarse biaxial test with one of the laws that fail.
Outcome run_with(const TemporaryFolder& folder, const std::string& law, const Words& more = {}) {
  Words words = coarse_case(folder / "out", {"--set", "material.plugin=" + library("bad_laws"), "--set",
                                             "material.model=" + law, "--set", "nonlocal.length=0", "--force"});
  words.insert(words.end(), more.begin(), more.end());
  return run(folder, words);
}

TEST(BadPlugin, WhoseLawThrowsWhileItIsMadeIsRefused) {
  const TemporaryFolder folder;
  const Outcome outcome = run_with(folder, "throws");
  EXPECT_EQ(outcome.code, 4);
  EXPECT_THAT(outcome.err, AllOf(HasSubstr("material 'throws' cannot be made"), HasSubstr("it has no licence")));
}

TEST(BadPlugin, WhoseLawCrashesWhileItIsMadeIsRefused) {
  const TemporaryFolder folder;
  const Outcome outcome = run_with(folder, "crashes");
  EXPECT_EQ(outcome.code, 4);
  EXPECT_THAT(outcome.err, AllOf(HasSubstr("material 'crashes' crashes while it is made"), HasSubstr("signal 11")));
}

TEST(BadPlugin, WhoseLawReportsFailureEndsTheRunWithPointAndStep) {
  const TemporaryFolder folder;
  const Outcome outcome = run_with(folder, "fails");
  EXPECT_EQ(outcome.code, 3);
  EXPECT_THAT(outcome.err, AllOf(HasSubstr("the law failed"), HasSubstr("it is Monday; stress ("), HasSubstr("step ")));
  EXPECT_THAT(file_content(folder / "out" / "summary.json"), HasSubstr("\"failed\""));
}

TEST(BadPlugin, WhoseLawThrowsInARunFailsItOnAnyNumberOfThreads) {
  const TemporaryFolder folder;
  for (const char* threads : {"1", "2"}) {
    const Outcome outcome = run_with(folder, "throws_in_a_run", {"--threads", threads});
    EXPECT_EQ(outcome.code, 3);
    EXPECT_THAT(outcome.err, AllOf(HasSubstr("it has lost its licence"), HasSubstr("step ")));
    EXPECT_THAT(file_content(folder / "out" / "summary.json"), HasSubstr("\"failed\""));
  }
}

TEST(BadPlugin, WhoseLawReturnsNanEndsTheRun) {
  const TemporaryFolder folder;
  const Outcome outcome = run_with(folder, "not_a_number");
  EXPECT_EQ(outcome.code, 3);
  EXPECT_THAT(outcome.err, AllOf(HasSubstr("it returned a stress that is not finite; stress (nan"),
                                 HasSubstr("first at point 0"), HasSubstr("step 0")));
  EXPECT_THAT(file_content(folder / "out" / "summary.json"), HasSubstr("\"failed\""));
}

} // namespace
} // namespace riedel::test
