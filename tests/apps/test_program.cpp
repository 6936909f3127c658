#include "apps/commands.hpp"
#include "temporary_folder.hpp"

#include <cstdlib>
#include <gmock/gmock.h>
#include <sys/wait.h>

using namespace riedel;
using testing::AllOf;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;
using testing::StartsWith;

namespace {

class Program : public testing::Test {
protected:
  struct Outcome {
    int code;
    std::string out, err;
  };
  [[nodiscard]] Outcome run(const std::string& arguments) const {
    const std::string out = (folder_ / "out").string(), err = (folder_ / "err").string();
    const int status = std::system((RIEDEL_PROGRAM " " + arguments + " >" + out + " 2>" + err).c_str());
    return {WEXITSTATUS(status), file_content(out), file_content(err)};
  }
  TemporaryFolder folder_;
};

} // namespace

TEST_F(Program, TellsItsVersionAndItsCommands) {
  EXPECT_THAT(run("--version").out, StartsWith("riedel "));
  EXPECT_THAT(run("--help").out, AllOf(HasSubstr("biaxial"), HasSubstr("check"), HasSubstr("list")));
  EXPECT_EQ(run("--help").code, 0);
  EXPECT_EQ(run("help").out, run("--help").out);
  for (const char* version : {"-v", "version", "biaxial --version", "list -v"})
    EXPECT_EQ(run(version).out, run("--version").out) << version;
}

TEST_F(Program, HelpsWithEveryCommand) {
  for (const char* command :
       {"biaxial", "element", "compare", "collect", "reproduce", "check", "list", "bench", "verify", "umat-check"}) {
    const Outcome help = run(std::string(command) + " --help");
    EXPECT_EQ(help.code, 0);
    EXPECT_THAT(help.out, HasSubstr(std::string("riedel ") + command));
    for (const char* way : {" -h", " help"}) EXPECT_EQ(run(command + std::string(way)).out, help.out) << command << way;
    EXPECT_EQ(run(std::string("help ") + command).out, help.out);
  }
  EXPECT_THAT(run("biaxial --help").out, AllOf(HasSubstr("nonlocal.length"), HasSubstr("material.phi_c")));
}

TEST_F(Program, HelpsWithTheTestTheLawAndTheSchemeThatAreNamed) {
  const std::string triaxial = run("element triaxial --help").out;
  EXPECT_THAT(triaxial, AllOf(HasSubstr("\"triaxial\""), HasSubstr("loading.confining_pressure")));
  EXPECT_THAT(triaxial, AllOf(Not(HasSubstr("loading.normal_stress")), Not(HasSubstr("loading.initial_pressure"))));
  EXPECT_EQ(run("help element triaxial").out, triaxial);
  EXPECT_THAT(run("element path --help").out, AllOf(HasSubstr("initial.sigma"), HasSubstr("Of each [[stage]]")));
  EXPECT_THAT(run("check --set test=shear --help").out, HasSubstr("loading.normal_stress"));
  for (const char* command : {"biaxial", "element shear", "check"}) {
    const std::string help = run(command + std::string(" --set material.model=drucker_prager --help")).out;
    EXPECT_THAT(help, AllOf(HasSubstr("material.cohesion "), Not(HasSubstr("material.phi_c")))) << command;
  }
  EXPECT_THAT(run("biaxial --set scheme=lme --help").out,
              AllOf(HasSubstr("interpolation.gamma"), Not(HasSubstr("interpolation.domain_limit"))));
  const Outcome wrong = run("biaxial --set material.model=drucker_pragr --help");
  EXPECT_EQ(wrong.code, 2);
  EXPECT_THAT(wrong.err, HasSubstr("did you mean 'drucker_prager'?"));
}

TEST_F(Program, EndsWithTwoWhenTheCommandIsWrong) {
  for (const char* wrong : {"", "biaxal", "check --unknown", "list everything", "check a b", "-x", "--set scheme=cpdi",
                            "biaxial -out there", "check --schema --set", "element triaxal"}) {
    const Outcome outcome = run(wrong);
    EXPECT_EQ(outcome.code, 2) << wrong;
    EXPECT_THAT(outcome.err, StartsWith("riedel: error: ")) << wrong;
    EXPECT_THAT(outcome.out, IsEmpty()) << wrong;
  }
}

TEST_F(Program, ChecksACaseAndTellsAllErrorsAtOnce) {
  const std::string path = folder_.file("wrong.toml", "scheme = 'cpid'\n[specimen]\nwidht = 3\nheight = '1 kPa'\n");
  const Outcome outcome = run("check " + path + " --set nonlocal.length=-1");
  EXPECT_EQ(outcome.code, 2);
  EXPECT_THAT(outcome.out, IsEmpty());
  for (const std::string& line : {path + ":1:10: scheme", path + ":3:9: specimen.widht",
                                  path + ":4:10: specimen.height", std::string("--set nonlocal.length")})
    EXPECT_THAT(outcome.err, HasSubstr("riedel: error: " + line + ": "));
}

TEST_F(Program, PrintsTheCaseInForceAsACaseThatGivesItself) {
  const Outcome first = run("check --set specimen.width='50 mm' --set imperfection.centre='[0.5, 0.5]'");
  EXPECT_EQ(first.code, 0);
  EXPECT_THAT(first.out, AllOf(StartsWith("# ok\n"), HasSubstr("width = 0.05 ")));
  EXPECT_EQ(run("check " + folder_.file("resolved.toml", first.out)).out, first.out);
}

TEST_F(Program, WarnsOnStandardErrorAndGoesOn) {
  const Outcome outcome = run("check --set grid.cells=[8,28]");
  EXPECT_EQ(outcome.code, 0);
  EXPECT_THAT(outcome.err, AllOf(StartsWith("riedel: warning: "), HasSubstr("l_c")));
  EXPECT_THAT(outcome.out, StartsWith("# ok\n"));
}

TEST_F(Program, ListsWhatACaseCanName) {
  EXPECT_THAT(run("list").out,
              AllOf(HasSubstr("gimp"), HasSubstr("gudehus_bauer"), HasSubstr("cell_list"), HasSubstr("gauss")));
  EXPECT_THAT(run("list materials").out, AllOf(StartsWith("materials\n"), HasSubstr("phi_c"), HasSubstr("deg")));
  EXPECT_THAT(run("list lists").err,
              HasSubstr("known: schemes, materials, searches, averagers, boundaries, transfers, plugins"));
}

TEST_F(Program, ListsAnEntryWhole) {
  const std::string law = run("list mohr_coulomb").out;
  EXPECT_THAT(law,
              AllOf(StartsWith("mohr_coulomb, law: "), HasSubstr("source: Clausen"), HasSubstr("cohesion "),
                    HasSubstr("    plastic_strain: "), HasSubstr("nothing with these values; the law is local then")));
  EXPECT_THAT(law, Not(HasSubstr("phi_c")));
  EXPECT_THAT(run("list cpdi gauss").out, AllOf(StartsWith("cpdi, interpolation scheme: "), HasSubstr("domain_limit"),
                                                HasSubstr("gauss, averager")));
  EXPECT_THAT(run("list nonlocal.length").out, AllOf(HasSubstr("0.0015 m"), Not(HasSubstr("nonlocal.search"))));
  EXPECT_THAT(run("list apic").out, HasSubstr("time.transfer"));
  EXPECT_THAT(run("list mohr_columb").err, HasSubstr("did you mean 'mohr_coulomb'?"));
}

TEST_F(Program, ListsEveryNameThatItLists) {
  for (const std::string& word : list_words()) {
    const Outcome outcome = run("list " + word);
    EXPECT_EQ(outcome.code, 0) << word << outcome.err;
    EXPECT_THAT(outcome.out, StartsWith(word));
  }
}

TEST_F(Program, PrintsTheSchemaAndTheReference) {
  EXPECT_THAT(run("check --schema").out, HasSubstr("\"$schema\""));
  EXPECT_THAT(run("check --reference").out, StartsWith("# Keys of a biaxial case"));
}

TEST_F(Program, TellsThatStandardOutputIsFull) {
  const int status = std::system((RIEDEL_PROGRAM " list >/dev/full 2>" + (folder_ / "err").string()).c_str());
  EXPECT_EQ(WEXITSTATUS(status), 3);
  EXPECT_THAT(file_content(folder_ / "err"), HasSubstr("cannot write to standard output"));
}
