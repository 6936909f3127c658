/// What --set accepts, and what it refuses.
#include "core/case_files.hpp"

namespace riedel::test {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::StartsWith;

TEST_F(CaseFiles, SettingsReplaceWhatTheFileSays) {
  CaseFile given = file("scheme = 'linear'\n[specimen]\nwidth = 1.0");
  for (const char* setting : {"scheme=cpdi", "specimen.width=0.05 m", "grid.cells=[12, 42]", "specimen.width=60 mm"})
    given.override_with(setting);
  const Values v = given.validate(keys());
  EXPECT_EQ(v.text("scheme"), "cpdi");          // a bare word
  EXPECT_EQ(v.number("specimen.width"), 60e-3); // the last one wins
  EXPECT_EQ(v.integers("grid.cells").front(), 12);
}

TEST_F(CaseFiles, AnErrorInASettingNamesTheSetting) {
  CaseFile given = CaseFile::empty();
  given.override_with("specimen.width=-1");
  given.override_with("specimen.widht=1");
  EXPECT_THAT(errors(given), AllOf(StartsWith("--set specimen.width: -1 is out of range"),
                                   HasSubstr("\n--set specimen.widht: unknown key")));
}

TEST_F(CaseFiles, RefusesASettingThatIsNone) {
  EXPECT_THAT(setting_error("specimen.width"), HasSubstr("KEY=VALUE"));
  for (const char* setting : {"=3", "a b=3", "[x]=3", "a..b=3", "a.=3", ".a=3", "#grid.cells=[1,1]", "'a=3",
                              "\"a.b\"=3", "é=3", "{}=3", "[=x]=3"})
    EXPECT_THAT(setting_error(setting), HasSubstr("is not the name of a key")) << setting;
}

TEST_F(CaseFiles, ASettingIsOneKeyOnOneLine) {
  for (const char* setting : {"#a=\nfoo bar", "a=1\nb=2", "a=1\r", "a=\x1b[31m", "grid.cells=[1,\n1]"})
    EXPECT_THAT(setting_error(setting), HasSubstr("a line break or another control character")) << setting;
  EXPECT_THAT(setting_error("scheme=\xff"), HasSubstr("is not UTF-8"));
}

TEST_F(CaseFiles, ASettingTakesNoComment) {
  for (const char* setting : {"specimen.width=1 # m", "grid.cells=[1,1] # few", "scheme='gimp'#x", "output.vtk=true #"})
    EXPECT_THAT(setting_error(setting), HasSubstr("a value cannot contain a comment")) << setting;
  EXPECT_EQ(with({"scheme='#1'"}).peek_text("scheme"), "#1");
  EXPECT_EQ(with({"scheme=sand #1"}).peek_text("scheme"), "sand #1"); // a text as it stands
}

TEST_F(CaseFiles, ASettingThatBeginsAsTomlHasToBeToml) {
  EXPECT_THAT(setting_error("grid.cells=[1,1"), HasSubstr("the value is not TOML: "));
  EXPECT_THAT(setting_error("scheme=\"gimp"), HasSubstr("the value is not TOML: "));
  EXPECT_THAT(setting_error("specimen={width=1, width=2}"), HasSubstr("the value is not TOML: "));
  for (const char* number : {"99999999999999999999", "01", "1.", "1e400"})
    EXPECT_THAT(setting_error("specimen.width=" + std::string(number)),
                testing::AnyOf(HasSubstr("the value is not TOML: "), HasSubstr("is not a finite number")))
        << number;
}

TEST_F(CaseFiles, ASettingMaySpellItsKeyAsTomlDoes) {
  for (const char* setting : {"grid . cells = [3, 4]", "'grid'.\"cells\"=[3,4]", "grid={cells=[3, 4]}"})
    EXPECT_EQ(with({setting}).validate(keys()).integers("grid.cells").back(), 4) << setting;
}

} // namespace
} // namespace riedel::test
