/// For a case given to the wrong command the message names the right one, which takes it.
#include "apps/program.hpp"

#include <gmock/gmock.h>

namespace riedel::test {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

class CaseKind : public testing::Test {
protected:
  [[nodiscard]] Outcome riedel(Words words) const {
    words.insert(words.end(), {"--out", (folder_ / "out").string(), "--force"});
    return run(folder_, words);
  }
  TemporaryFolder folder_;
  std::string biaxial_ = folder_.file("biaxial.toml", "[imperfection]\nsize = [0, 0]\n"
                                                      "[nonlocal]\nlength = 0\n[grid]\ncells = [4, 8]\n"
                                                      "[loading]\nspeed = 1\nfinal_strain = 0.001\n"
                                                      "[output]\nvtk = false\nplots = false\n");
  std::string shear_ =
      folder_.file("shear.toml", "test = \"shear\"\n[loading]\nnormal_stress = 1e5\nfinal_strain = 0.01\n"
                                 "[output]\nplots = false\n");
};

TEST_F(CaseKind, OfABiaxialTestIsToldByElementAndTakenByBiaxial) {
  const Outcome refused = riedel({"element", "biaxial", biaxial_});
  EXPECT_EQ(refused.code, 2);
  EXPECT_THAT(refused.err,
              HasSubstr(biaxial_ + ":2:8: imperfection.size: is no key of 'riedel element biaxial' (nor are 2 "
                                   "more); 'riedel biaxial' takes them\n"));
  const Outcome taken = riedel({"biaxial", biaxial_});
  EXPECT_EQ(taken.code, 0) << taken.err;
}

TEST_F(CaseKind, OfAnElementTestIsToldByBiaxialAndTakenByElement) {
  const Outcome refused = riedel({"biaxial", shear_});
  EXPECT_EQ(refused.code, 2);
  EXPECT_THAT(refused.err,
              HasSubstr(shear_ + ":1:8: test: is no key of 'riedel biaxial' (nor are 1 more); 'riedel element "
                                 "shear' takes them\n"));
  const Outcome taken = riedel({"element", "shear", shear_});
  EXPECT_EQ(taken.code, 0) << taken.err;
  EXPECT_EQ(run(folder_, {"check", shear_}).code, 0);
}

TEST_F(CaseKind, DecidesWhatRunsAStudyHas) {
  const Outcome outcome = riedel({"compare", shear_, "--vary", "specimen.void_ratio=0.6,0.7"});
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_TRUE(std::filesystem::exists(folder_ / "out" / "void_ratio=0.7" / "element.csv"));
  EXPECT_THAT(riedel({"compare", shear_, "--vary", "imperfection.factor=0.5,1"}).err,
              HasSubstr("--vary imperfection.factor: unknown key"));
}

TEST_F(CaseKind, IsToldForSingleSettings) {
  EXPECT_THAT(
      riedel({"element", "triaxial", "--set", "nonlocal.length=0"}).err,
      AllOf(HasSubstr("--set nonlocal.length: is no key of 'riedel element triaxial'; 'riedel biaxial' takes it\n"),
            Not(HasSubstr("check --help"))));
  EXPECT_THAT(run(folder_, {"check", "--set", "loading.normal_stress=1e5"}).err,
              HasSubstr("'riedel element shear', or a case that says 'test = \"shear\"' takes it"));
}

TEST_F(CaseKind, StandsBehindACommand) {
  EXPECT_THAT(run(folder_, {shear_}).err,
              HasSubstr("is a file, not a command; 'riedel element shear " + shear_ + "' runs"));
  EXPECT_THAT(run(folder_, {biaxial_}).err, HasSubstr("'riedel biaxial " + biaxial_ + "' runs a case"));
}

TEST_F(CaseKind, DecidesWhichHelpAnUnknownKeyNames) {
  EXPECT_THAT(riedel({"element", "shear", "--set", "colour.of=1"}).err,
              HasSubstr("'riedel element shear --help' lists"));
  EXPECT_THAT(riedel({"biaxial", "--set", "colour.of=1"}).err, HasSubstr("'riedel biaxial --help' lists"));
  EXPECT_THAT(run(folder_, {"umat-check", "mine.so", "--set", "colour.of=1"}).err,
              HasSubstr("'riedel umat-check --help' lists"));
}

} // namespace
} // namespace riedel::test
