/// Input that is wrong in unusual ways: reported with exit code 2, and never a crash.
#include "apps/program.hpp"

#include <gmock/gmock.h>

namespace riedel::test {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;

class OddInput : public testing::Test {
protected:
  [[nodiscard]] std::string refusal(const Words& words) const {
    const Outcome outcome = run(folder_, words);
    EXPECT_EQ(outcome.code, 2) << outcome.out << outcome.err;
    EXPECT_EQ(outcome.out, "");
    return outcome.err;
  }
  [[nodiscard]] std::string check(const std::string& setting) const { return refusal({"check", "--set", setting}); }
  TemporaryFolder folder_;
};

TEST_F(OddInput, ASettingThatIsTwoLinesOrAComment) {
  EXPECT_THAT(check("#a=\nfoo bar"), HasSubstr("--set #a="));
  EXPECT_THAT(check("#grid.cells=[1,1]"), HasSubstr("'#grid.cells' is not the name of a key"));
  EXPECT_THAT(check("time.cfl=0.3 # careful"), HasSubstr("a value cannot contain a comment"));
  EXPECT_THAT(check("time.cfl=0.3\ngrid.cells=[1,1]"), HasSubstr("allowed: one key and its value"));
  EXPECT_THAT(check("specimen.width=1e99999999999 m"), HasSubstr("is too large or too small for a number"));
}

TEST_F(OddInput, ACaseThatNestsDeeperThanTheStack) {
  std::string name = "a";
  for (int i = 0; i < 300000; ++i) name += ".a";
  EXPECT_THAT(refusal({"check", folder_.file("deep.toml", name + " = 1\n")}), HasSubstr("deep.toml:1:"));
}

TEST_F(OddInput, AMessageHoldsNoSignThatSteersATerminal) {
  const std::string said = refusal({"check", folder_.file("odd.toml", "\"\x1b[2J\" = 1\n\"a\\u001bc\" = 1\n")});
  EXPECT_THAT(said, AllOf(Not(HasSubstr("\x1b")), StartsWith("riedel: error: ")));
}

TEST_F(OddInput, AFolderWhoseNameIsNoUtf8HoldsARunAndACampaign) {
  const std::filesystem::path folder = folder_ / "sand\xff";
  Words words = coarse_case(folder / "run", {"--set", "output.plots=false"});
  EXPECT_EQ(run(folder_, words).code, 0);
  EXPECT_TRUE(std::filesystem::exists(folder / "run/summary.json"));
  words = {"compare", "--vary", "time.cfl=0.2,0.3", "--script", "parallel", "--out", (folder / "campaign").string()};
  EXPECT_EQ(run(folder_, words).code, 0);
  EXPECT_EQ(run(folder_, words).code, 0); // what it wrote can be read
  std::filesystem::rename(folder_.file("case.toml", ""), folder / "e\xcc.toml");
  words = {"compare", (folder / "e\xcc.toml").string(), "--vary", "time.cfl=0.2", "--script", "parallel",
           "--out",   (folder / "titled").string()};
  EXPECT_EQ(run(folder_, words).code, 0);
}

TEST_F(OddInput, AValueInTwoSpellingsIsOneCase) {
  const std::string said = refusal({"compare", "--vary", "nonlocal.length=1.5mm,0.0015", "--dry-run"});
  EXPECT_THAT(said, HasSubstr("length=1.5mm and length=0.0015 are the same case"));
  EXPECT_THAT(refusal({"element", "triaxial", "--vary", "loading.confining_pressure=100kPa,1e5"}),
              HasSubstr("are the same case"));
}

} // namespace
} // namespace riedel::test
