/// The manual page: nothing of the tables is missing, and formatters accept it without warnings.
#include "apps/biaxial/keys.hpp"
#include "apps/built_in.hpp"
#include "apps/command_help.hpp"
#include "apps/commands.hpp"
#include "apps/manual.hpp"
#include "apps/program.hpp"

#include <gmock/gmock.h>

namespace riedel::test {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;

bool works(const std::string& command) { return std::system(("(" + command + ") >/dev/null 2>&1").c_str()) == 0; }

TEST(Manual, EscapesWhatRoffWouldRead) {
  EXPECT_EQ(roff("a-b\\c"), "a\\-b\\ec");
  EXPECT_EQ(roff(".TH"), "\\&.TH");
  EXPECT_EQ(roff("'quoted'"), "\\&'quoted'");
  EXPECT_EQ(roff("\xCF\x86 \xE2\x89\xA5 0"), "\\[u03C6] \\[u2265] 0");
}

TEST(Manual, HasItsSectionsInTheirOrder) {
  const std::string page = manual_page(commands(), "1970-01-02");
  std::size_t at = 0;
  for (const char* section : {"NAME", "SYNOPSIS", "DESCRIPTION", "COMMANDS", "OPTIONS", "KEYS", "FILES", "EXIT STATUS",
                              "ENVIRONMENT", "EXAMPLES", "SEE ALSO"}) {
    const std::size_t found = page.find("\n.SH " + std::string(section) + "\n");
    ASSERT_NE(found, std::string::npos) << section;
    EXPECT_GT(found, at) << section;
    at = found;
  }
}

TEST(Manual, HasEveryCommandOptionKeySchemeLawAndCode) {
  const std::string page = manual_page(commands(), "1970-01-02");
  for (const Command& command : commands()) {
    EXPECT_THAT(page, HasSubstr("\n.SS " + roff("riedel " + command.name + " ")));
    EXPECT_THAT(page, HasSubstr(roff(command.summary)));
    for (const Option& option : command.options)
      EXPECT_THAT(page, HasSubstr("\\fB" + roff("--" + option.name) + "\\fR"));
  }
  const Catalogue catalogue = full_catalogue();
  for (const Key& key : biaxial_keys(catalogue, paper_model))
    EXPECT_THAT(page, HasSubstr("\\fB" + roff(key.name) + "\\fR"));
  for (const std::string& name : catalogue.in_2d.schemes.names()) EXPECT_THAT(page, HasSubstr("\\fB" + name + "\\fR"));
  for (const std::string& name : catalogue.materials.names()) EXPECT_THAT(page, HasSubstr("\\fB" + name + "\\fR"));
  for (const char* text :
       {"0", "1", "2", "3", "4", "130, 143", "OMP_NUM_THREADS", "RIEDEL_PLUGIN_PATH", "NO_COLOR", "TMPDIR"})
    EXPECT_THAT(page, HasSubstr("\\fB" + std::string(text) + "\\fR"));
}

TEST(Manual, IsWhatTheProgramPrints) {
  const TemporaryFolder folder;
  ::setenv("SOURCE_DATE_EPOCH", "86400", 1);
  const Outcome printed = run(folder, {"--man"});
  ::unsetenv("SOURCE_DATE_EPOCH");
  EXPECT_EQ(printed.out, manual_page(commands(), "1970-01-02"));
}

TEST(Manual, IsFormattedWithoutAWarning) {
  const TemporaryFolder folder;
  const std::string page = folder.file("riedel.1", manual_page(commands(), "1970-01-02")),
                    log = (folder / "log").string();
  const Words formatters{"groff -man -Tutf8 -ww -z ", "man --warnings -l -Tutf8 -Z ", "mandoc -Tlint -Wwarning "};
  int found = 0;
  for (const std::string& formatter : formatters) {
    if (!works("command -v " + formatter.substr(0, formatter.find(' ')))) continue;
    ++found;
    const std::string command = "LC_ALL=C.UTF-8 " + formatter + page + " 2>&1 >/dev/null | cat >" + log;
    EXPECT_EQ(std::system(command.c_str()), 0);
    EXPECT_THAT(file_content(log), IsEmpty()) << formatter;
  }
  if (found == 0) GTEST_SKIP() << "neither groff nor man nor mandoc is installed";
}

} // namespace
} // namespace riedel::test
