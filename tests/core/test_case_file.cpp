#include "core/case_files.hpp"

namespace riedel::test {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::StartsWith;

TEST_F(CaseFiles, AnEmptyCaseKeepsEveryDefault) {
  EXPECT_EQ(CaseFile::empty().validate(keys()).all(), Values(keys()).all());
  EXPECT_EQ(file("").validate(keys()).all(), Values(keys()).all());
  EXPECT_EQ(file("[specimen]\n").validate(keys()).all(), Values(keys()).all());
}

TEST_F(CaseFiles, ReadsNumbersUnitsWordsAndLists) {
  const Values v = file("scheme = 'cpdi'\n[specimen]\nwidth = '50 mm'\nheight = 1\n[grid]\ncells = [12, 42]\n"
                        "[imperfection]\nsize = [1, '2 mm']\n[time]\nstep = '1 us'\n[output]\nvtk = false")
                       .validate(keys());
  EXPECT_EQ(v.text("scheme"), "cpdi");
  EXPECT_EQ(v.number("specimen.width"), 0.05);
  EXPECT_TRUE(std::holds_alternative<double>(v.at("specimen.height"))); // an integer where a number is wanted
  EXPECT_EQ(v.integers("grid.cells"), (std::vector<std::int64_t>{12, 42}));
  EXPECT_EQ(v.numbers("imperfection.size"), (std::vector<double>{1.0, 2e-3}));
  EXPECT_EQ(v.number("time.step"), 1e-6);
  EXPECT_FALSE(v.flag("output.vtk"));
}

TEST_F(CaseFiles, AWordOrANumberMayStandForTheSameKey) {
  EXPECT_TRUE(CaseFile::empty().validate(keys()).is_text("time.step"));
  EXPECT_EQ(file("time.step = 2e-6").validate(keys()).number("time.step"), 2e-6);
  EXPECT_EQ(file("time.step = 'auto'").validate(keys()).text("time.step"), "auto");
  EXPECT_THAT(errors("time.step = 'automatic'"), HasSubstr("auto, or a number > 0 in s"));
  EXPECT_THAT(errors("time.step = 0.0"), HasSubstr("out of range"));
}

TEST_F(CaseFiles, AnErrorBeginsWithFileLineColumnAndKey) {
  EXPECT_THAT(errors("[specimen]\n  width = -1.0\n"),
              StartsWith(path() + ":2:11: specimen.width: -1.0 is out of range"));
}

TEST_F(CaseFiles, SuggestsTheKeyThatWasMeant) {
  EXPECT_THAT(errors("[specimen]\nwitdh = 1.0"),
              HasSubstr("specimen.witdh: unknown key (did you mean 'specimen.width'?)"));
  EXPECT_THAT(errors("[spcimen]\nwidth = 1.0"), HasSubstr("did you mean 'specimen.width'?"));
  EXPECT_THAT(errors("height = 1.0"), HasSubstr("did you mean 'specimen.height'?"));
  EXPECT_THAT(errors("[specimen]\ncolour = 1"), HasSubstr("[specimen] takes width, height, void_ratio"));
  EXPECT_THAT(errors("[nothing]"), HasSubstr("nothing: unknown key"));
}

TEST_F(CaseFiles, NamesWhatIsAllowedWhenTheTypeIsWrong) {
  EXPECT_THAT(errors("specimen.width = true"),
              HasSubstr("true is not a number; allowed: a number > 0 in m, or a text with a unit (m, cm, mm, um)"));
  EXPECT_THAT(errors("specimen.width = [1.0]"), HasSubstr("is a list; allowed: a number"));
  EXPECT_THAT(errors("specimen.width = 2020-01-01"), HasSubstr("2020-01-01 is not a number"));
  EXPECT_THAT(errors("specimen = 1"), HasSubstr("specimen: is a section"));
  EXPECT_THAT(errors("specimen.width = {}"), HasSubstr("is a section, not a value"));
  EXPECT_THAT(errors("scheme = 3"), HasSubstr("3 is not a text; allowed: linear, gimp, cpdi"));
  EXPECT_THAT(errors("output.vtk = 1"), HasSubstr("1 is not true or false"));
  EXPECT_THAT(errors("grid.cells = [true, 84]"),
              HasSubstr("is not an integer; allowed: a list of 2, each an integer ≥ 1"));
  EXPECT_THAT(errors("grid.cells = 24"), HasSubstr("24 is not a list"));
  EXPECT_THAT(errors("grid.cells = [24]"), HasSubstr("has 1 entries instead of 2"));
}

TEST_F(CaseFiles, NamesTheUnitsThatAreAllowed) {
  EXPECT_THAT(errors("specimen.width = '40 kPa'"),
              AllOf(HasSubstr("has a unit of another kind"), HasSubstr("m, cm, mm")));
}

TEST_F(CaseFiles, RefusesNumbersOutOfRange) {
  EXPECT_THAT(errors("nonlocal.length = '-1 mm'"), HasSubstr("out of range; allowed: a number ≥ 0 in m"));
  EXPECT_THAT(errors("grid.cells = [0, 84]"), HasSubstr("out of range"));
  EXPECT_THAT(errors("material.phi_c = 90"), HasSubstr("out of range; allowed: a number in (0, 90) deg"));
}

TEST_F(CaseFiles, AnUnknownChoiceListsTheKnownOnes) {
  EXPECT_THAT(errors("scheme = 'cpid'"),
              HasSubstr("\"cpid\" is not known (did you mean 'cpdi'?); allowed: linear, gimp, cpdi"));
}

TEST_F(CaseFiles, TellsAllErrorsAtOnceInTheOrderOfTheFile) {
  const std::string text = errors("[specimen]\nwidth = -1.0\nheight = 'tall'\n[grid]\ncels = 3\n");
  EXPECT_EQ(std::ranges::count(text, '\n'), 2);
  EXPECT_LT(text.find(":2:"), text.find(":3:"));
  EXPECT_LT(text.find(":3:"), text.find(":5:"));
}

TEST_F(CaseFiles, TellsLineAndColumnOfASyntaxError) {
  EXPECT_THAT([&] { (void)file("[specimen]\nwidth = = 3\n"); },
              testing::ThrowsMessage<InputError>(StartsWith(path() + ":2:9: not valid TOML: ")));
}

TEST_F(CaseFiles, LooksUpATextBeforeValidation) {
  const CaseFile given = file("scheme = 'anything'\n[grid]\ncells = 3");
  EXPECT_EQ(given.peek_text("scheme"), "anything");
  EXPECT_EQ(given.peek_text("grid.cells"), std::nullopt);
  EXPECT_EQ(given.peek_text("specimen.width"), std::nullopt);
}

TEST_F(CaseFiles, TellsWhereAKeyWasGiven) {
  CaseFile given = file("[specimen]\nwidth = 1.0");
  given.override_with("specimen.height=2");
  EXPECT_EQ(given.place("specimen.width"), path() + ":2:9: specimen.width");
  EXPECT_EQ(given.place("specimen.height"), "--set specimen.height");
  EXPECT_EQ(given.place("scheme"), "scheme (default)");
}

TEST_F(CaseFiles, NumbersTheTablesOfAnArray) {
  const Keys staged{{"stage.1.speed", 0.0, "m/s", {}, "speed"},
                    {"stage.2.speed", 0.0, "m/s", {}, "speed"},
                    {"stage.2.leg.1.speed", 0.0, "m/s", {}, "speed"}};
  CaseFile given = file("[[stage]]\nspeed = 1\n[[stage]]\nspeed = 2\n[[stage.leg]]\nspeed = 3\n");
  EXPECT_EQ(given.count("stage"), 2);
  EXPECT_EQ(given.count("stage.2.leg"), 1);
  EXPECT_EQ(given.count("stage.1.leg"), 0);
  EXPECT_EQ(given.count("speed"), 0);
  given.override_with("stage.1.speed=4");
  const Values v = given.validate(staged);
  EXPECT_EQ(v.number("stage.1.speed"), 4);
  EXPECT_EQ(v.number("stage.2.speed"), 2);
  EXPECT_EQ(v.number("stage.2.leg.1.speed"), 3);
}

} // namespace
} // namespace riedel::test
