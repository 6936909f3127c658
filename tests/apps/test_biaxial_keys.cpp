#include "apps/biaxial/keys.hpp"
#include "apps/fake_catalogue.hpp"
#include "core/base/error.hpp"
#include "core/case/case_text.hpp"
#include "temporary_folder.hpp"

#include <algorithm>
#include <cmath>
#include <gmock/gmock.h>

using namespace riedel;
using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;
using testing::StartsWith;

namespace {

CaseFile with(std::initializer_list<const char*> settings) {
  CaseFile given = CaseFile::empty();
  for (const char* setting : settings) given.override_with(setting);
  return given;
}
CheckedCase accepted(std::initializer_list<const char*> settings) {
  return biaxial_case(with(settings), fake_catalogue());
}
std::string errors(std::initializer_list<const char*> settings) {
  try {
    (void)accepted(settings);
  } catch (const InputError& error) { return error.what(); }
  return "no error";
}

} // namespace

TEST(BiaxialKeys, DefaultsAreThePapersAndFitToRun) {
  const CheckedCase paper = accepted({});
  EXPECT_THAT(paper.warnings, IsEmpty());
  EXPECT_EQ(paper.values.number("specimen.width"), 0.040);
  EXPECT_EQ(paper.values.number("specimen.height"), 0.140);
  EXPECT_EQ(paper.values.number("specimen.void_ratio"), 0.55);
  EXPECT_EQ(paper.values.number("imperfection.void_ratio"), 0.90);
  EXPECT_EQ(paper.values.number("loading.confining_pressure"), 50e3);
  EXPECT_EQ(paper.values.number("nonlocal.length"), 1.5e-3);
  EXPECT_THAT(paper.values.integers("grid.cells"), ElementsAre(24, 84));
  EXPECT_EQ(paper.values.text("scheme"), "gimp");
  EXPECT_EQ(paper.values.text("material.model"), "gudehus_bauer");
}

TEST(BiaxialKeys, EveryDefaultPassesItsOwnCheckAndHasADoc) {
  const Keys keys = biaxial_keys(fake_catalogue(), paper_model);
  const TemporaryFolder folder;
  const Values again = CaseFile::read(folder.file("case.toml", case_text(keys, Values(keys)))).validate(keys);
  EXPECT_EQ(again.all(), Values(keys).all());
  for (const Key& key : keys) EXPECT_NE(key.doc, "") << key.name;
}

TEST(BiaxialKeys, TheLawDecidesWhichParametersThereAre) {
  EXPECT_EQ(accepted({"material.model=linear_elastic", "material.youngs_modulus=20 MPa"})
                .values.number("material.youngs_modulus"),
            20e6);
  EXPECT_THAT(errors({"material.model=linear_elastic", "material.phi_c=30"}),
              HasSubstr("unknown key; [material] takes model, plugin, youngs_modulus"));
}

TEST(BiaxialKeys, AnUnknownLawIsTheOnlyErrorAndListsTheKnownOnes) {
  const std::string text = errors({"material.model=gudehus", "material.phi_c=33 deg"});
  EXPECT_THAT(text, AllOf(StartsWith("--set material.model: \"gudehus\" is not known (did you mean 'gudehus_bauer'?)"),
                          HasSubstr("allowed: gudehus_bauer, linear_elastic"), Not(HasSubstr("phi_c"))));
}

TEST(BiaxialKeys, UnknownSchemesAndSearchesListTheKnownOnes) {
  EXPECT_THAT(errors({"scheme=spline"}), HasSubstr("allowed: linear, gimp, cpgimp, cpdi"));
  EXPECT_THAT(errors({"nonlocal.search=octree"}), HasSubstr("allowed: cgal_kd_tree, cell_list"));
  EXPECT_THAT(errors({"nonlocal.averager=mean"}), HasSubstr("allowed: gauss"));
  EXPECT_THAT(errors({"nonlocal.variable=stress"}), HasSubstr("allowed: rate_norm, void_ratio"));
  EXPECT_THAT(errors({"time.order=msul"}), HasSubstr("did you mean 'musl'?"));
}

TEST(BiaxialKeys, RefuseNumbersOutOfRange) {
  for (const char* setting : {"specimen.width=0",
                              "specimen.points_per_cell=0",
                              "grid.cells=[0, 84]",
                              "grid.cells=[24]",
                              "loading.speed=-0.1",
                              "loading.final_strain=1.0",
                              "loading.confining_pressure=0 kPa",
                              "material.phi_c=90",
                              "material.phi_c=2 rad",
                              "nonlocal.length=-1 mm",
                              "time.step=0.0",
                              "time.cfl=0.0",
                              "time.cfl=1.1",
                              "time.flip=1.5",
                              "time.xpic_order=0",
                              "time.xpic_order=41",
                              "output.every_strain=0.0",
                              "specimen.width=1 kPa",
                              "grid.cells=[24.0, 84.0]",
                              "output.vtk=1"})
    EXPECT_THAT(errors({setting}), HasSubstr("allowed: ")) << setting;
}

TEST(BiaxialCheck, TheVoidRatioLiesBetweenItsLimitsAtTheConfiningPressure) {
  const double e_d = 0.51 * std::exp(-std::pow(3.0 * 50e3 / 190e6, 0.5)); // 0.4959
  EXPECT_THAT(errors({"specimen.void_ratio=0.4958"}),
              AllOf(StartsWith("--set specimen.void_ratio: 0.4958 is out of range"), HasSubstr("(0.4959, 1.264]")));
  EXPECT_EQ(errors({("specimen.void_ratio=" + exact_text(e_d * (1 + 1e-12))).c_str()}), "no error");
  EXPECT_THAT(errors({("specimen.void_ratio=" + exact_text(e_d)).c_str()}), HasSubstr("is out of range"));
  EXPECT_THAT(errors({"imperfection.void_ratio=1.27"}), StartsWith("--set imperfection.void_ratio: 1.27"));
  EXPECT_THAT(errors({"material.h_s=1 kPa"}), AllOf(HasSubstr("specimen.void_ratio (default): 0.55 is out of range"),
                                                    HasSubstr("imperfection.void_ratio (default): 0.9 is out")));
}

TEST(BiaxialCheck, TheLimitingVoidRatiosAreInOrder) {
  EXPECT_THAT(errors({"material.e_c0=0.5"}), HasSubstr("material.e_c0: 0.5 does not lie between e_d0 = 0.51"));
  EXPECT_THAT(errors({"material.e_i0=0.82"}), HasSubstr("does not lie between"));
}

TEST(BiaxialCheck, TheImperfectionLiesInsideTheSpecimen) {
  EXPECT_THAT(errors({"imperfection.centre=[0.05, 0.5]"}),
              HasSubstr("--set imperfection.centre: the patch reaches from"));
  EXPECT_THAT(errors({"imperfection.size=[5 mm, 5 mm]"}),
              HasSubstr("a number with a unit needs quotes: \"5 mm\"")); // an unquoted unit in a list
  EXPECT_THAT(errors({"imperfection.size=['5 mm', '200 mm']"}), HasSubstr("specimen's [0, 0.14] m (specimen.height)"));
  EXPECT_EQ(errors({"imperfection.centre=[0.0, 1.0]", "imperfection.size=[0.0, 0.0]"}), "no error");
}

TEST(BiaxialCheck, PointsCanBeNumbered) {
  EXPECT_THAT(errors({"grid.cells=[100000, 100000]"}), HasSubstr("points are too many"));
}

TEST(BiaxialCheck, RefusesALengthWithIntergranularStrainWhichTakesNothingAveraged) {
  EXPECT_THAT(errors({"material.intergranular_strain=true", "nonlocal.length=1.5e-3"}),
              AllOf(StartsWith("--set nonlocal.length: 0.0015 is out of range"), HasSubstr("allowed: 0")));
  EXPECT_EQ(errors({"material.intergranular_strain=true", "nonlocal.length=0"}), "no error");
}

TEST(BiaxialKeys, AnUnknownCureOfLockingListsTheKnownOnes) {
  EXPECT_THAT(errors({"time.locking=fbar"}),
              AllOf(HasSubstr("did you mean 'f_bar'?"), HasSubstr("allowed: none, f_bar")));
}

TEST(BiaxialKeys, AnUnknownTransferListsTheKnownOnes) {
  EXPECT_THAT(errors({"time.transfer=apci"}),
              AllOf(HasSubstr("did you mean 'apic'?"), HasSubstr("allowed: flip, apic, tpic, xpic")));
}

TEST(BiaxialCheck, RefusesNumbersThatTheTransferWouldNotLookAt) {
  for (const char* transfer : {"time.transfer=apic", "time.transfer=tpic", "time.transfer=xpic"}) {
    EXPECT_THAT(errors({transfer, "time.flip=0.9"}),
                AllOf(StartsWith("--set time.flip: 0.9 means nothing to"), HasSubstr("time.transfer = \"flip\"")));
    EXPECT_THAT(errors({transfer, "time.damping=500"}),
                AllOf(StartsWith("--set time.damping: 500.0 means nothing to"), HasSubstr("time.transfer = \"flip\"")));
    EXPECT_EQ(errors({transfer}), "no error");
    EXPECT_EQ(errors({transfer, "time.flip=damping", "time.damping=auto"}), "no error") << "a run's own case.toml";
  }
  EXPECT_THAT(errors({"time.flip=0.98", "time.damping=500"}), HasSubstr("give only one of them"));
  EXPECT_EQ(errors({"time.flip=0.98"}), "no error");
  EXPECT_EQ(errors({"time.damping=0"}), "no error");
  for (const char* transfer : {"time.transfer=apic", "time.transfer=tpic", "time.transfer=flip"})
    EXPECT_THAT(errors({transfer, "time.xpic_order=3"}),
                AllOf(StartsWith("--set time.xpic_order: 3 means nothing to"), HasSubstr("time.transfer = \"xpic\"")));
  EXPECT_EQ(errors({"time.transfer=xpic", "time.xpic_order=3"}), "no error");
}

TEST(BiaxialCheck, RefusesAStressFilterWhoseNumbersDoNotFit) {
  EXPECT_THAT(
      errors({"time.stress_filter=1e4", "time.volume_filter=2e3"}),
      AllOf(StartsWith("--set time.volume_filter: 2000.0 1/s is more than a tenth of time.stress_filter, 10000.0"),
            HasSubstr("allowed: up to 1000.0 1/s")));
  EXPECT_THAT(errors({"time.stress_filter=-1"}), HasSubstr("--set time.stress_filter: "));
  EXPECT_THAT(errors({"time.stress_filter=1e9"}),
              AllOf(HasSubstr("is more than one per time step of"), HasSubstr("allowed: up to")));
  EXPECT_THAT(errors({"time.stress_filter=0", "time.stress_filter_order=8"}), HasSubstr("a filter without a rate"));
  EXPECT_THAT(errors({"time.stress_filter=0", "time.stress_filter_steps=8"}), HasSubstr("a filter without a rate"));
  EXPECT_THAT(errors({"time.stress_filter_order=0"}), HasSubstr("allowed"));
  EXPECT_THAT(errors({"time.stress_filter_steps=101"}), HasSubstr("allowed"));
  EXPECT_EQ(errors({"time.stress_filter=0"}), "no error");
  EXPECT_EQ(errors({"time.stress_filter=5e3", "time.volume_filter=0"}), "no error");
}

TEST(BiaxialCheck, RefusesApicWithASchemeThatDoesNotSpreadPoints) {
  EXPECT_THAT(errors({"time.transfer=apic", "scheme=linear"}),
              AllOf(StartsWith("--set time.transfer: \"apic\" is not offered by the scheme \"linear\""),
                    HasSubstr("take one of gimp, cpgimp, cpdi, or another transfer")));
  EXPECT_THAT(accepted({"time.transfer=tpic", "scheme=linear"}).warnings,
              ElementsAre(AllOf(StartsWith("--set time.transfer: \"tpic\" with the scheme \"linear\""),
                                HasSubstr("safe with gimp, cpgimp, cpdi"))));
  EXPECT_THAT(accepted({"time.transfer=tpic"}).warnings, IsEmpty());
}

TEST(BiaxialCheck, RefusesInThreeDimensionsWhatIsThereInTwoAlone) {
  EXPECT_THAT(errors({"grid.dimensions=3"}),
              AllOf(HasSubstr("scheme (default): \"gimp\" is not offered in three dimensions; take one of cpdi, or "
                              "grid.dimensions = 2"),
                    HasSubstr("nonlocal.search (default): \"cgal_kd_tree\" is not offered"),
                    HasSubstr("nonlocal.averager (default): \"gauss\" is not offered in three dimensions; take "
                              "grid.dimensions = 2")));
  EXPECT_EQ(errors({"grid.dimensions=2"}), "no error");
}

TEST(BiaxialCheck, WarnsWhenThePointsAreTooFarApartForTheAverage) {
  EXPECT_THAT(
      accepted({"grid.cells=[16, 56]"}).warnings,
      ElementsAre(AllOf(StartsWith("nonlocal.length (default): the points are 0.0025 m apart"), HasSubstr("0.00165"))));
  EXPECT_THAT(accepted({"grid.cells=[16, 56]", "specimen.points_per_cell=2"}).warnings, IsEmpty());
  EXPECT_THAT(accepted({"grid.cells=[16, 56]", "nonlocal.length=0"}).warnings, IsEmpty());
  EXPECT_THAT(accepted({"grid.cells=[32, 112]"}).warnings, IsEmpty());
}

TEST(CheckedCase, TellsErrorsOfSingleAndOfSeveralKeysTogether) {
  const std::string text = errors({"scheme=no", "specimen.void_ratio=0.2", "grid.cels=[1, 1]"});
  EXPECT_EQ(std::ranges::count(text, '\n'), 2);
  EXPECT_THAT(text, AllOf(HasSubstr("--set scheme"), HasSubstr("--set specimen.void_ratio: 0.2 is out of range"),
                          HasSubstr("--set grid.cels")));
}

TEST(CheckedCase, DrawsNoConclusionFromAWrongKey) {
  EXPECT_EQ(errors({"material.h_s=1 m", "specimen.void_ratio=0.2"}).find("specimen.void_ratio"), std::string::npos);
}
