#include "core/io/readable.hpp"
#include "core/io/toml_words.hpp"

#include <gtest/gtest.h>

namespace riedel {
namespace {

TEST(Readable, KeepsWhatIsUtf8) {
  for (const char* text : {"", "plain", "é µ 文 𝛿", "a\tb"}) {
    EXPECT_EQ(valid_utf8(text), std::string_view(text).size());
    EXPECT_EQ(readable(text), text);
  }
}

TEST(Readable, PutsASignInPlaceOfWhatIsNot) {
  EXPECT_EQ(readable("a\xff"), "a\uFFFD");
  EXPECT_EQ(readable("\xC3"), "\uFFFD");                     // cut off
  EXPECT_EQ(readable("\xC0\xAF"), "\uFFFD\uFFFD");           // longer than need be
  EXPECT_EQ(readable("\xED\xA0\x80"), "\uFFFD\uFFFD\uFFFD"); // half of a pair
  EXPECT_EQ(valid_utf8("ab\xF4\x90\x80\x80"), 2U);           // beyond the last character
}

TEST(Readable, LetsNoSignSteerATerminal) {
  EXPECT_EQ(readable("\x1b[31m"), "\uFFFD[31m");
  EXPECT_EQ(readable("a\nb\x7f"), "a\uFFFDb\uFFFD");
  EXPECT_EQ(readable("\xC2\x9B"), "\uFFFD"); // ESC [ in one
}

TEST(Readable, CutsBetweenCharacters) {
  EXPECT_EQ(readable("abc", 3), "abc");
  EXPECT_EQ(readable("abcd", 3), "abc...");
  EXPECT_EQ(readable("éé", 3), "é...");
}

TEST(TomlWords, HideWhatStandsInQuotes) {
  EXPECT_EQ(without_quoted("a = \"#, ]\" # b"), "a =        # b");
  EXPECT_EQ(without_quoted("'it\"s',[\"a\\\"]\"]"), "      ,[      ]");
  EXPECT_EQ(without_quoted("\"\"\"a\"b\"\"\",c"), "         ,c");
  EXPECT_EQ(without_quoted("x,'open, "), "x,       ");
  EXPECT_EQ(without_quoted("1 # don't\n'a'"), "1 # don't\n   ");
}

} // namespace
} // namespace riedel
