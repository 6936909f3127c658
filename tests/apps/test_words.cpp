/// Texts of any kind as words of a shell, as names of files and as cells of a table.
#include "core/io/csv_cell.hpp"
#include "core/io/file_name.hpp"
#include "core/io/shell_word.hpp"
#include "temporary_folder.hpp"

#include <cstdlib>
#include <gmock/gmock.h>

using namespace riedel;

TEST(ShellWord, IsOneLineThatTheShellTakesForTheText) {
  const TemporaryFolder folder;
  for (const std::string text : {"plain", "", "two words", "it's", "$(touch hit)`touch hit`", "a\nb;touch hit\n#c",
                                 "\"", "\\", "100%\n\\n", "*", "~", "-n", "tab\tand\rreturn", "ä ö", "'\n'"}) {
    const std::string word = shell_word(text);
    EXPECT_EQ(word.find('\n'), std::string::npos);
    const std::string script =
        folder.file("script", "cd '" + folder.path().string() + "'\nprintf '%s' " + word + " # " + word);
    ASSERT_EQ(std::system(("sh " + script + " >" + (folder / "out").string()).c_str()), 0);
    EXPECT_EQ(file_content(folder / "out"), text);
    EXPECT_FALSE(std::filesystem::exists(folder / "hit")) << text;
  }
}

TEST(ShellWord, IsTheTextItselfWhereThatIsSafe) {
  EXPECT_EQ(shell_word("--set"), "--set");
  EXPECT_EQ(shell_word("nonlocal.length=1.5e-3"), "nonlocal.length=1.5e-3");
  EXPECT_EQ(shell_word("grid.cells=[8,28]"), "'grid.cells=[8,28]'");
}

TEST(FileName, LeadsNowhereElse) {
  for (const char* name : {"scheme=gimp,length=1.5e-3", "16x56", "e0=0.75", "cells=[16,56]", "ä"})
    EXPECT_TRUE(is_file_name(name)) << name;
  for (const std::string& name : {std::string(), std::string("."), std::string(".."), std::string("a/b"),
                                  std::string("/a"), std::string("a\\b"), std::string("a\0b", 3), std::string("a\nb"),
                                  std::string("a\x1b"), std::string("a\x7f"), std::string(".a"), std::string(256, 'a')})
    EXPECT_FALSE(is_file_name(name)) << name;
}

TEST(FileName, IsMadeOfAnyText) {
  EXPECT_EQ(file_name_for("cells=[16,56]"), "cells=[16,56]");
  EXPECT_EQ(file_name_for("plugin=\"a/b c\"\n"), "plugin=_a_b_c__");
  std::string text(300, 'a'), other = text + "b", umlauts;
  for (int i = 0; i < 200; ++i) umlauts += "ä";
  for (const std::string& longer : {text, other, umlauts, std::string("../x"), std::string("a\0b", 3)})
    EXPECT_TRUE(is_file_name(file_name_for(longer))) << file_name_for(longer);
  EXPECT_NE(file_name_for(text), file_name_for(other));
  EXPECT_EQ(static_cast<unsigned char>(file_name_for(umlauts)[178]), 0xc3) << "no half of a letter";
}

TEST(CsvCell, IsNoFormula) {
  for (const char* number : {"-1.5e-3", "+2", "-inf", "nan", "0.5", "-0"}) EXPECT_EQ(csv_cell(number), number);
  EXPECT_EQ(csv_cell("=1+2"), "'=1+2");
  EXPECT_EQ(csv_cell("+-1"), "'+-1");
  EXPECT_EQ(csv_cell("-1+2"), "'-1+2");
  EXPECT_EQ(csv_cell("@SUM(A1,A2)"), "\"'@SUM(A1,A2)\"");
  EXPECT_EQ(csv_cell("\t=1"), "'\t=1");
  EXPECT_EQ(csv_cell("a \"b\", c"), "\"a \"\"b\"\", c\"");
  EXPECT_EQ(csv_cell(""), "");
}
