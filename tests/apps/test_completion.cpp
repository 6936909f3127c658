/// The completions, in their shells.
#include "apps/commands.hpp"
#include "apps/completion.hpp"
#include "apps/program.hpp"
#include "core/base/error.hpp"

#include <gmock/gmock.h>

namespace riedel::test {
namespace {

using testing::Contains;
using testing::ElementsAre;
using testing::IsEmpty;
using testing::IsSupersetOf;
using testing::Not;
using testing::UnorderedElementsAre;
using testing::UnorderedElementsAreArray;

bool works(const std::string& command) { return std::system(("(" + command + ") >/dev/null 2>&1").c_str()) == 0; }

class Completion : public testing::TestWithParam<std::string> {
protected:
  void SetUp() override {
    if (!works(GetParam() + " -c true")) GTEST_SKIP() << GetParam() << " is not installed";
    folder_.file("script", completion(GetParam(), commands()));
    folder_.file("case.toml", "");
    folder_.file("law.so", "");
    std::filesystem::create_directory(folder_ / "results");
  }
  /// Completions of the last word; the words follow `riedel`.
  [[nodiscard]] Words completed(const Words& words) const {
    std::string line;
    for (const std::string& word : words) line += " '" + word + "'";
    const std::string text = GetParam() == "bash" ? bash(line, words.size()) : zsh(line, words.size());
    const std::string driver = folder_.file("driver", text), out = (folder_ / "out").string();
    EXPECT_TRUE(works("cd " + folder_.path().string() + " && " + GetParam() + " driver >" + out + " 2>err"))
        << file_content(folder_ / "err");
    std::istringstream lines(file_content(out));
    Words found;
    for (std::string word; std::getline(lines, word);) found.push_back(word);
    return found;
  }
  TemporaryFolder folder_;

private:
  static std::string bash(const std::string& line, std::size_t count) {
    return "source ./script\nCOMP_WORDS=(riedel" + line + ")\nCOMP_CWORD=" + std::to_string(count) +
           "\n_riedel\n[ ${#COMPREPLY[@]} -eq 0 ] || printf '%s\\n' \"${COMPREPLY[@]}\"\n";
  }
  /// Replaces zsh's own functions for completion, and prints what matches.
  static std::string zsh(const std::string& line, std::size_t count) {
    return "compdef() { : }\ncompset() { : }\nsource ./script\n"
           "compadd() { while [[ $1 != -- ]]; do shift; done; shift\n"
           "  for word in $@; do [[ $word == ${words[CURRENT]}* ]] && print -r -- $word; done; true }\n"
           "_files() { if [[ $1 == -/ ]]; then print -l -- *(/); else print -l -- *(/) ${~2}; fi }\n"
           "words=(riedel" +
           line + ")\nCURRENT=" + std::to_string(count + 1) + "\n_riedel\n";
  }
};

TEST_P(Completion, KnowsTheCommands) {
  EXPECT_THAT(completed({""}), IsSupersetOf({"biaxial", "element", "compare", "check", "list", "umat-check"}));
  EXPECT_THAT(completed({"bi"}), ElementsAre("biaxial"));
  EXPECT_THAT(completed({"help", "ver"}), ElementsAre("verify"));
}

TEST_P(Completion, KnowsTheOptionsOfEveryCommand) {
  for (const Command& command : commands()) {
    Words options{"--help", "--version"};
    for (const Option& option : command.options) options.push_back("--" + option.name);
    EXPECT_THAT(completed({command.name, "--"}), UnorderedElementsAreArray(options)) << command.name;
  }
}

TEST_P(Completion, KnowsKeysAndTheirValues) {
  EXPECT_THAT(completed({"biaxial", "--set", "nonlocal.le"}), ElementsAre("nonlocal.length="));
  EXPECT_THAT(completed({"biaxial", "--set", "output.vtk="}),
              UnorderedElementsAre("output.vtk=true", "output.vtk=false"));
  EXPECT_THAT(completed({"biaxial", "--set", "scheme=bs"}), UnorderedElementsAre("scheme=bspline2", "scheme=bspline3"));
  EXPECT_THAT(completed({"element", "shear", "--set", "loading.n"}), ElementsAre("loading.normal_stress="));
  EXPECT_THAT(completed({"element", "triaxial", "--set", "loading.n"}), IsEmpty());
}

TEST_P(Completion, KnowsTheParametersOfTheLawInForce) {
  EXPECT_THAT(completed({"biaxial", "--set", "material.phi"}), ElementsAre("material.phi_c="));
  const Words cohesive = completed({"biaxial", "--set", "material.model=mohr_coulomb", "--set", "material."});
  EXPECT_THAT(cohesive, Contains("material.cohesion="));
  EXPECT_THAT(cohesive, Not(Contains("material.phi_c=")));
}

TEST_P(Completion, KnowsTheNamesOfLists) {
  EXPECT_THAT(completed({"compare", "--schemes", "gimp,cpd"}), UnorderedElementsAre("gimp,cpdi", "gimp,cpdi2"));
  EXPECT_THAT(completed({"compare", "--vary", "scheme=gimp,bs"}),
              UnorderedElementsAre("scheme=gimp,bspline2", "scheme=gimp,bspline3"));
  EXPECT_THAT(completed({"list", "mohr"}), ElementsAre("mohr_coulomb"));
  EXPECT_THAT(completed({"element", "tri"}), ElementsAre("triaxial"));
  EXPECT_THAT(completed({"element", "triaxial", "--driver", ""}), UnorderedElementsAre("point", "mpm"));
  EXPECT_THAT(completed({"reproduce", "--figure", "1"}), ElementsAre("10"));
}

TEST_P(Completion, KnowsFiles) {
  EXPECT_THAT(completed({"biaxial", ""}), UnorderedElementsAre("case.toml", "results"));
  EXPECT_THAT(completed({"biaxial", "--out", ""}), ElementsAre("results"));
  EXPECT_THAT(completed({"biaxial", "-o", ""}), ElementsAre("results"));
  EXPECT_THAT(completed({"element", "shear", ""}), UnorderedElementsAre("case.toml", "results"));
  EXPECT_THAT(completed({"bench", "--plugin", ""}), UnorderedElementsAre("law.so", "results"));
}

INSTANTIATE_TEST_SUITE_P(Shells, Completion, testing::ValuesIn(completion_shells()),
                         [](const auto& tested) { return tested.param; });

TEST(CompletionOfBash, MendsWordsThatReadlineHasBroken) {
  const TemporaryFolder folder;
  folder.file("script", completion("bash", commands()));
  folder.file("driver", "source ./script\nCOMP_WORDS=(riedel biaxial --set scheme = cpd)\nCOMP_CWORD=5\n_riedel\n"
                        "printf '%s\\n' \"${COMPREPLY[@]}\"\n");
  ASSERT_TRUE(works("cd " + folder.path().string() + " && bash driver >out"));
  EXPECT_EQ(file_content(folder / "out"), "cpdi\ncpdi2\n");
}

TEST(CompletionScript, IsWhatTheProgramPrintsAndNamesTheShellsItKnows) {
  const TemporaryFolder folder;
  EXPECT_EQ(run(folder, {"--completion", "zsh"}).out, completion("zsh", commands()));
  const Outcome wrong = run(folder, {"--completion", "zish"});
  EXPECT_EQ(wrong.code, 2);
  EXPECT_THAT(wrong.err, testing::HasSubstr("did you mean 'zsh'?); known: bash, zsh"));
}

} // namespace
} // namespace riedel::test
