/// What cannot be run is refused before the run, through the real program: with the key, the reason and alternatives,
/// and without writing to the output folder.
#include "apps/program.hpp"

#include <gmock/gmock.h>

namespace riedel::test {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::StartsWith;

class Refusal : public testing::Test {
protected:
  /// The message of `command` with settings, which must end with 2 and write nothing.
  std::string refusal(Words words, const Words& settings) const {
    const std::filesystem::path out = folder_ / "out";
    words.insert(words.end(), {"--out", out.string()});
    for (const std::string& setting : settings) words.insert(words.end(), {"--set", setting});
    const Outcome outcome = run(folder_, words);
    EXPECT_EQ(outcome.code, 2) << outcome.err;
    EXPECT_FALSE(std::filesystem::exists(out));
    return outcome.err;
  }
  [[nodiscard]] Outcome check(const Words& settings) const {
    Words words{"check"};
    for (const std::string& setting : settings) words.insert(words.end(), {"--set", setting});
    return run(folder_, words);
  }
  TemporaryFolder folder_;
};

TEST_F(Refusal, OfPressureOnPointsUnderCubicSplinesTellsWhatIsLeftAndWhatToTake) {
  EXPECT_THAT(
      refusal({"biaxial"}, {"scheme=bspline3", "loading.lateral=points"}),
      AllOf(StartsWith("riedel: error: --set loading.lateral: \"points\" starts out of balance under the scheme "
                       "\"bspline3\" with 1 per cell and direction: nodes at the sides retain 28.1"),
            HasSubstr("take \"virtual_stress\", exact for every scheme, or one of the schemes linear, gimp, "
                      "cpgimp, cpdi, cpdi2, ddmp"),
            HasSubstr("bspline2\n")));
}

TEST_F(Refusal, OfPressureOnPointsDependsOnThePointsInACell) {
  const Words two{"scheme=bspline2", "loading.lateral=points", "specimen.points_per_cell=2"};
  EXPECT_THAT(refusal({"biaxial"}, two), AllOf(HasSubstr("\"bspline2\" with 2 per cell"), HasSubstr("cpdi2, ddmp\n")));
  EXPECT_EQ(check({two[0], two[1]}).code, 0);
  EXPECT_EQ(check({two[0], two[2]}).code, 0);
}

TEST_F(Refusal, OfMorePointsInACellThanThereMayBeTellsHowManyMay) {
  EXPECT_THAT(
      refusal({"biaxial"}, {"specimen.points_per_cell=11", "scheme=cpdi"}),
      StartsWith("riedel: error: --set specimen.points_per_cell: 11 is out of range; allowed: an integer in [1, "
                 "10]"));
  EXPECT_THAT(refusal({"element", "biaxial", "--driver", "mpm"}, {"specimen.points_per_cell=11", "scheme=cpdi"}),
              HasSubstr("specimen.points_per_cell: 11 is out of range; allowed: an integer in [1, 10]"));
}

TEST_F(Refusal, OfABodyThatReachesOutOfTheSpecimenTellsHowFar) {
  EXPECT_THAT(refusal({"biaxial"}, {"imperfection.centre=[1.0, 0.5]"}),
              AllOf(HasSubstr("--set imperfection.centre: the patch reaches from 0.0375 m to 0.0425 m"),
                    HasSubstr("out of the specimen's [0, 0.04] m (specimen.width)")));
}

TEST_F(Refusal, OfATransferThatTheSchemeDoesNotOfferNamesThoseThatDo) {
  for (const Words& command : {Words{"biaxial"}, Words{"element", "shear", "--driver", "mpm"}})
    EXPECT_THAT(
        refusal(command, {"scheme=linear", "time.transfer=apic"}),
        AllOf(StartsWith("riedel: error: --set time.transfer: \"apic\" is not offered by the scheme \"linear\""),
              HasSubstr("which gives a point on a line of nodes no weight beside that line; take one of gimp"),
              HasSubstr("or another transfer")));
}

TEST_F(Refusal, OfAnUnknownSchemeOrTransferNamesTheKnownOnes) {
  EXPECT_THAT(refusal({"biaxial"}, {"scheme=bspline4", "grid.dimensions=3"}),
              HasSubstr("--set scheme: \"bspline4\" is not known (did you mean 'bspline2'?); allowed: linear, gimp"));
  EXPECT_THAT(refusal({"biaxial"}, {"time.transfer=pic"}), HasSubstr("allowed: flip, apic, tpic, xpic"));
}

TEST_F(Refusal, OfAGeometryNamesItsDimensions) {
  EXPECT_THAT(refusal({"biaxial"}, {"specimen.depth_cells=3"}),
              HasSubstr("--set specimen.depth_cells: 3 means nothing in two dimensions; leave it out, or take "
                        "grid.dimensions = 3"));
  EXPECT_THAT(refusal({"biaxial"}, {"grid.dimensions=4"}), HasSubstr("allowed: an integer in [2, 3]"));
  EXPECT_THAT(refusal({"element", "triaxial", "--driver", "mpm"}, {"grid.dimensions=2"}),
              HasSubstr("2 is plane strain, and a triaxial test is not; allowed: 3, \"auto\""));
}

} // namespace
} // namespace riedel::test
