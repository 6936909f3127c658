/// Case files with unusual errors, and some with common ones.
#include "core/case_files.hpp"

namespace riedel::test {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::StartsWith;

TEST_F(CaseFiles, ANumberThatIsNoneOrNotFiniteIsRefusedEverywhere) {
  for (const char* value : {"nan", "inf", "-inf", "+nan"}) {
    EXPECT_THAT(setting_error("specimen.width=" + std::string(value)), HasSubstr("is not a finite number"));
    EXPECT_THAT(errors("imperfection.size = [0.0, " + std::string(value) + "]"),
                HasSubstr("at place 2 is not a finite number"));
  }
  for (const char* value : {"1979-05-27", "07:32:00", "1979-05-27T07:32:00Z", "{a = 1}", "[[1], [2]]"})
    EXPECT_NE(setting_error("imperfection.size=" + std::string(value)), "no error") << value;
}

TEST_F(CaseFiles, AnIntegerThatHasAPointIsToldToLoseIt) {
  EXPECT_THAT(errors("grid.cells = [24.0, 84]"),
              HasSubstr("at place 1 is not an integer, which has no point and no exponent: write 24; allowed"));
  EXPECT_THAT(errors("grid.cells = [2.5, 84]"), HasSubstr("at place 1 is not an integer; allowed"));
  EXPECT_EQ(file("grid.cells = [0x10, 1_000]").validate(keys()).integers("grid.cells").front(), 16);
}

/// As without VTK, or without a search.
TEST_F(CaseFiles, AValueThatThisBuildDoesWithoutIsRefusedWithHowToGetIt) {
  Key plots{"output.plots", false, "", {}, "write"}, scheme = keys().front();
  plots.left_out = {{"true", "takes VTK: configure with -DRIEDEL_WITH_VTK=ON"}};
  scheme.left_out = {{"lme", "takes more"}};
  const auto error = [&](std::string_view text) -> std::string {
    try {
      (void)file(text).validate({plots, scheme});
    } catch (const InputError& refused) { return refused.what(); }
    return "no error";
  };
  EXPECT_THAT(
      error("[output]\nplots = true"),
      HasSubstr("case.toml:2:9: output.plots: true takes VTK: configure with -DRIEDEL_WITH_VTK=ON; allowed: false"));
  EXPECT_EQ(error("[output]\nplots = false"), "no error");
  EXPECT_THAT(error("scheme = 'lme'"), HasSubstr("takes more; allowed: linear, gimp, cpdi"));
  EXPECT_THAT(error("scheme = 'lm'"), HasSubstr("is not known"));
}

TEST_F(CaseFiles, AQuotedNameWithADotIsAnotherKey) {
  EXPECT_THAT(errors("\"grid.cells\" = [1, 1]"), HasSubstr(":1:16: \"grid.cells\": unknown key"));
  EXPECT_THAT(errors("\"a\\nb\" = 1"), HasSubstr("\"a\\u000ab\": unknown key")); // and its message has one line
}

TEST_F(CaseFiles, WhatIsNoTextIsToldWithItsPlace) {
  EXPECT_THAT(syntax_error(std::string_view("\xff\xfes\0", 4)), HasSubstr("is written in UTF-16"));
  EXPECT_THAT(syntax_error(std::string_view("a = 1\nb\0", 8)), HasSubstr("case.toml:2:2: not valid TOML: a zero byte"));
  EXPECT_THAT(syntax_error("a = 'é'\nb = '\xff'"),
              HasSubstr("case.toml:2:6: not valid TOML: a byte that is not UTF-8"));
  EXPECT_THAT(syntax_error("a = '\xed\xa0\x80'"), HasSubstr("not UTF-8")); // half of a pair
  EXPECT_THAT(syntax_error(std::string(5 << 20, '#')), HasSubstr("larger than 4 MiB"));
  EXPECT_EQ(file("\xEF\xBB\xBFscheme = 'cpdi'\r\n").validate(keys()).text("scheme"), "cpdi");
}

TEST_F(CaseFiles, WhatGoesTooDeepIsRefusedBeforeTheStackEnds) {
  const auto many = [](std::string_view text, int times) {
    std::string all;
    for (int i = 0; i < times; ++i) all += text;
    return all;
  };
  EXPECT_THAT(syntax_error("a" + many(".a", 300000) + " = 1"), HasSubstr("a name with more than 64 dots"));
  EXPECT_THAT(syntax_error("[a" + many(" . a", 100000) + "]"), HasSubstr("a name with more than 64 dots"));
  EXPECT_THAT(syntax_error("a = " + many("[", 300000)), HasSubstr("depth"));
  EXPECT_THAT(syntax_error("a = " + many("{a=", 300000)), HasSubstr("depth"));
  EXPECT_EQ(file("# " + many(".", 300) + "\n").validate(keys()).all(), Values(keys()).all());
}

TEST_F(CaseFiles, WhatTheReaderOfTomlTakesForGrantedIsRefusedWithItsPlace) {
  for (const char* text : {"a = 1\n[=x]\n", "a = 1\n[[=x]]\n", "a = 1\n[+]\n", "a = 1\n[.x]\n", "a = 1\n[#x]\n"})
    EXPECT_THAT(syntax_error(text), HasSubstr("case.toml:2:")) << text;
}

TEST_F(CaseFiles, ALetterBeyondAsciiStandsInQuotesOnly) {
  for (const char* text : {"é = 1", "[ŝx]", "a = é", "a.ö = 1", "a = {ü = 1}", "\u00a0a = 1"})
    EXPECT_THAT(syntax_error(text), HasSubstr("a letter beyond ASCII, which is allowed only in quotes")) << text;
  for (const char* text : {"a = 0_'''x = é", "a = \"\\é\"", "a = \"\"\"\\é\"\"\""})
    EXPECT_THAT(syntax_error(text), HasSubstr(":1:")) << text;
  for (const char* text : {"a = 'é' # é 'ü", "a = \"\"\"é\"\"\"\"\nb = 'ü'", "a = '''é\n'ü'''''", "a = \"\\\"é\""})
    EXPECT_EQ(syntax_error(text), "no error") << text;
}

TEST_F(CaseFiles, AWordWithoutQuotesIsToldToTakeThem) {
  EXPECT_THAT(syntax_error("[specimen]\nscheme = gimp # best\n"),
              AllOf(StartsWith("case.toml:2:10: not valid TOML: "), HasSubstr("a text needs quotes: \"gimp\"")));
  EXPECT_THAT(syntax_error("scheme = false_friend\n"), HasSubstr("needs quotes: \"false_friend\""));
  EXPECT_THAT(syntax_error("schemes = [\"gimp\", cpdi]\n"), HasSubstr("case.toml:1:20: "));
  EXPECT_THAT(syntax_error("schemes = [gimp, cpdi]\n"), HasSubstr("a text needs quotes: \"gimp\""));
  EXPECT_THAT(syntax_error("width = 1.5 mm\n"), HasSubstr("a number with a unit needs quotes: \"1.5 mm\""));
  EXPECT_THAT(syntax_error("width = 1.5mm\n"), HasSubstr("a number with a unit needs quotes: \"1.5mm\""));
  EXPECT_THAT(syntax_error("width = 1,5\n"), HasSubstr("a point, not a comma"));
  EXPECT_THAT(syntax_error("vtk = True\n"), HasSubstr("in lower case: true"));
}

TEST_F(CaseFiles, CountsTheTablesOfAnArrayUpToTheFirstThatIsMissing) {
  EXPECT_EQ(with({"stage.2000000000.speed=1"}).count("stage"), 0);
  EXPECT_EQ(with({"stage.1.speed=1", "stage.3.speed=1", "stage.2x.speed=1", "stage.02.speed=1"}).count("stage"), 1);
}

TEST_F(CaseFiles, TellsAHundredErrorsAtMost) {
  std::string text;
  for (int i = 0; i < 1000; ++i) text += "key_" + std::to_string(i) + " = 1\n";
  EXPECT_EQ(std::ranges::count(errors(text), '\n'), 100);
}

} // namespace
} // namespace riedel::test
