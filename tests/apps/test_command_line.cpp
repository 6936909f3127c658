#include "apps/command_help.hpp"
#include "apps/commands.hpp"
#include "core/base/error.hpp"

#include <cstdlib>
#include <gmock/gmock.h>
#include <omp.h>

using namespace riedel;
using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::ThrowsMessage;

namespace {

Command command() {
  return {"biaxial", "[CASE.toml]", "A test.", 1, run_options("there"), [](const Arguments&) { return 0; }};
}
Arguments parsed(const std::vector<std::string>& words) { return parse(command(), words); }
auto error_with(const char* text) { return ThrowsMessage<InputError>(HasSubstr(text)); }

} // namespace

TEST(CommandLine, TakesWordsAndOptionsInAnyOrder) {
  const Arguments a =
      parsed({"--set", "scheme=cpdi", "case.toml", "--out=there", "--set", "nonlocal.length=-1", "--force"});
  EXPECT_THAT(a.words, ElementsAre("case.toml"));
  EXPECT_THAT(a.options.at("set"), ElementsAre("scheme=cpdi", "nonlocal.length=-1"));
  EXPECT_EQ(a.out("here"), "there");
  EXPECT_TRUE(a.force());
  EXPECT_EQ(parsed({}).out("here"), "here");
  EXPECT_FALSE(parsed({}).force());
}

TEST(CommandLine, PutsTheSettingsOnTheCase) {
  EXPECT_EQ(parsed({"--set", "scheme=linear", "--set", "scheme=cpdi"}).case_file().peek_text("scheme"), "cpdi");
  EXPECT_THROW((void)parsed({"/no/such/case.toml"}).case_file(), InputError);
  EXPECT_THAT([] { (void)parsed({"scheme=cpdi"}).case_file(); }, error_with("did you mean '--set scheme=cpdi'?"));
}

TEST(CommandLine, RefusesWhatTheCommandDoesNotKnow) {
  EXPECT_THAT(
      [] {
        (void)parsed({"--ste", "a=1"});
      },
      ThrowsMessage<InputError>(AllOf(HasSubstr("--ste (did you mean '--set'?)"), HasSubstr("riedel biaxial --help"))));
  EXPECT_THAT([] { (void)parsed({"--forc"}); }, error_with("unknown option --forc")); // no abbreviations
  EXPECT_THAT([] { (void)parsed({"-x"}); }, error_with("unknown option -x;"));
  EXPECT_THAT([] { (void)parsed({"-out", "there"}); }, error_with("unknown option -out (did you mean '--out'?)"));
  EXPECT_THAT([] { (void)parsed({"a.toml", "b.toml"}); }, error_with("'b.toml' is one word too many"));
  EXPECT_THAT([] { (void)parsed({"--out"}); }, error_with("--out needs a value: --out DIR; see"));
  EXPECT_THAT([] { (void)parsed({"--out="}); }, error_with("--out needs a value"));
  EXPECT_THAT([] { (void)parsed({"--force=1"}); }, error_with("--force takes no value; see 'riedel biaxial --help'"));
}

TEST(CommandLine, TellsWhichOtherCommandTakesAnOption) {
  const auto message = [](const Command& command, const std::string& word) {
    try {
      (void)parse(command, {word}, commands());
    } catch (const InputError& error) { return std::string(error.what()); }
    return std::string("no error");
  };
  const auto& all = commands();
  EXPECT_THAT(message(find_command(all, "biaxial"), "--script"),
              HasSubstr("unknown option --script; 'riedel compare' takes it; see 'riedel biaxial --help'"));
  EXPECT_THAT(message(find_command(all, "collect"), "--out"), HasSubstr(" and others take it; see 'riedel collect"));
  EXPECT_THAT(message(find_command(all, "biaxial"), "--shcemes"), Not(HasSubstr("takes it")));
}

/// So that words can be appended to those of a script.
TEST(CommandLine, TakesTheLastOfAnOptionThatIsGivenTwice) {
  EXPECT_EQ(parsed({"--out", "a", "-o", "b"}).out("here"), "b");
  EXPECT_EQ(parsed({"--force", "--force"}).words.size(), 0U); // says the same
  const Command lists{"bench", "", "A test.", 0, {{"schemes", "A,B", "a list"}}, nullptr};
  EXPECT_THAT(parse(lists, {"--schemes", "a", "--schemes", "b,c"}).list("schemes", {}), ElementsAre("a", "b", "c"));
}

TEST(CommandLine, TakesLettersForSomeOptionsAndHelpAsAWord) {
  EXPECT_EQ(parsed({"-o", "there"}).out("here"), "there");
  EXPECT_TRUE(parsed({"case.toml", "-h"}).has("help"));
  EXPECT_TRUE(parsed({"-v"}).has("version"));
  EXPECT_TRUE(parsed({"case.toml", "help"}).has("help"));
  EXPECT_THAT(parsed({"case.toml", "help"}).words, ElementsAre("case.toml"));
  EXPECT_FALSE(parsed({"--out", "help"}).has("help"));
}

TEST(CommandLine, TellsWhichNameOfAListIsUnknown) {
  const std::vector<std::string> known{"gimp", "cpdi"};
  EXPECT_THAT(
      [&] {
        refuse_unknown_names("--schemes", {"gimp", "cpid"}, known);
      },
      error_with("--schemes gimp,cpid: number 2 of the list, cpid, is unknown (did you mean 'cpdi'?); known: gimp"));
  EXPECT_THAT([&] { refuse_unknown_names("--schemes", {"foo"}, known); },
              error_with("--schemes foo: unknown; known: "));
  EXPECT_NO_THROW(refuse_unknown_names("--schemes", {"cpdi", "gimp"}, known));
}

TEST(CommandLine, TakesAPositiveNumberOfThreads) {
  const auto threads = [](const std::vector<std::string>& words) {
    const ThreadRange range = parsed(words).threads();
    return std::pair(range.minimum, range.maximum);
  };
  EXPECT_EQ(threads({"--threads", "3"}), std::pair(3, 3));
  EXPECT_EQ(threads({"--threads", "1-4"}), std::pair(1, 4));
  ::unsetenv("OMP_NUM_THREADS");
  EXPECT_EQ(threads({}), std::pair(1, omp_get_num_procs()));
  const int before = omp_get_max_threads();
  omp_set_num_threads(5); // as OpenMP does at the start of a program
  ::setenv("OMP_NUM_THREADS", "5", 1);
  EXPECT_EQ(threads({}), std::pair(5, 5)) << "OMP_NUM_THREADS is the default where it is set";
  EXPECT_EQ(threads({"--threads", "2"}), std::pair(2, 2));
  ::unsetenv("OMP_NUM_THREADS");
  omp_set_num_threads(before);
  for (const char* wrong : {"0", "-1", "two", "2.5", "", "99999999999", "4-2", "0-2", "1-", "-", "1-4-8", "1-2000"})
    EXPECT_THAT(
        [&] {
          (void)parsed({"--threads", wrong}).threads();
        },
        error_with("allowed: an integer in [1, 1024], or a range"))
        << wrong;
}

TEST(CommandLine, FindsCommandsAndSuggestsTheOneThatWasMeant) {
  EXPECT_EQ(find_command(commands(), "check").name, "check");
  EXPECT_THAT([] { (void)find_command(commands(), "biaxal"); }, error_with("did you mean 'biaxial'?"));
  EXPECT_THAT([] { (void)find_command(commands(), "shear"); }, error_with("did you mean 'riedel element shear'?"));
  EXPECT_THAT([] { (void)find_command(commands(), "dance"); },
              error_with("known: biaxial, element, compare, collect, reproduce, check, list"));
}

TEST(CommandLine, TheHelpNamesEveryCommandAndEveryOption) {
  for (const Command& each : commands()) {
    EXPECT_THAT(help(commands()), AllOf(HasSubstr(each.name), HasSubstr(each.summary)));
    EXPECT_THAT(help(each), AllOf(HasSubstr("riedel " + each.name), HasSubstr(each.summary), HasSubstr("--help")));
    for (const Option& option : each.options)
      EXPECT_THAT(help(each), AllOf(HasSubstr("--" + option.name), HasSubstr(option.doc)));
  }
}
