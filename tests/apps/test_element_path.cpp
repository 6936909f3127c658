/// Keys of element tests, and the resulting paths.
#include "apps/element/keys.hpp"
#include "apps/element/path.hpp"
#include "core/base/error.hpp"
#include "core/case/case_text.hpp"
#include "core/case/vary.hpp"
#include "support/problems.hpp"
#include "temporary_folder.hpp"

#include <gmock/gmock.h>

namespace riedel::test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

class ElementPaths : public testing::Test {
protected:
  [[nodiscard]] CheckedCase checked(const std::string& text) const {
    return element_case(CaseFile::read(folder_.file("case.toml", text)), catalogue());
  }
  [[nodiscard]] ElementPath path(const std::string& text) const {
    return element_path(ElementCase(checked(text).values));
  }
  [[nodiscard]] std::string errors(const std::string& text) const {
    try {
      (void)checked(text);
    } catch (const InputError& error) { return error.what(); }
    return "no error";
  }
  TemporaryFolder folder_;
};

/// "eps_1=0.1", or "sigma_2" if it is kept constant.
std::vector<std::string> words(const PathLeg& leg) {
  std::vector<std::string> all;
  for (const Prescription& each : leg.prescriptions)
    all.push_back(each.measure->name + (each.target ? "=" + short_text(*each.target) : ""));
  return all;
}

TEST_F(ElementPaths, TheTestsOfThePaperAreWhatTheirNamesSay) {
  EXPECT_THAT(words(path("test = 'triaxial'").stages[0].legs[0]),
              ElementsAre("gamma", "gamma_13", "gamma_23", "eps_1=0.3", "sigma_2", "sigma_3"));
  EXPECT_THAT(words(path("test = 'biaxial'").stages[0].legs[0]),
              ElementsAre("gamma", "gamma_13", "gamma_23", "eps_1=0.06", "sigma_2", "eps_3"));
  EXPECT_THAT(words(path("test = 'oedometer'").stages[0].legs[0]),
              ElementsAre("gamma", "gamma_13", "gamma_23", "eps_1=0.06", "eps_2", "eps_3"));
  EXPECT_THAT(words(path("test = 'shear'").stages[0].legs[0]),
              ElementsAre("gamma=0.5", "gamma_13", "gamma_23", "eps_1", "sigma_2", "eps_3"));
  EXPECT_EQ(path("test = 'shear'").stress.m[1], -200e3);
  EXPECT_EQ(path("test = 'oedometer'").stress.m[2], -1e3);
}

TEST_F(ElementPaths, LegsTakeWhatTheirStageSaysAndCanSayOtherwise) {
  const ElementPath given = path("test = 'path'\n[[stage]]\nrepeat = 7\nuntil = 'q > 30 kPa'\nsigma_1 = 'hold'\n"
                                 "sigma_2 = 'hold'\neps_3 = 'hold'\n[[stage.leg]]\ngamma = 0.01\n[[stage.leg]]\n"
                                 "tau = '-5 kPa'\nsigma_2 = '90 kPa'\n");
  ASSERT_EQ(given.stages.size(), 1U);
  const PathStage& stage = given.stages[0];
  EXPECT_EQ(stage.repeat, 7);
  EXPECT_EQ(stage.name, "stage 1");
  EXPECT_TRUE(stage.until->above);
  EXPECT_EQ(stage.until->limit, 30e3);
  ASSERT_EQ(stage.legs.size(), 2U);
  EXPECT_THAT(words(stage.legs[0]), ElementsAre("eps_3", "gamma=0.01", "sigma_1", "sigma_2", "gamma_13", "gamma_23"));
  EXPECT_THAT(words(stage.legs[1]),
              ElementsAre("eps_3", "sigma_1", "sigma_2=9e+04", "tau=-5e+03", "gamma_13", "gamma_23"));
}

TEST_F(ElementPaths, LimitsAreNumbersOrTextsWithAUnit) {
  for (const auto& [text, same] : {std::pair{"gamma > 0.05", "gamma > 0.05"},
                                   {"eps_v<-1e-3", "eps_v < -0.001"},
                                   {"p < 20 kPa", "p < 20000.0 Pa"},
                                   {"p < 2e4", "p < 20000.0 Pa"},
                                   {"phi_mob > 35", "phi_mob > 35.0 deg"}})
    EXPECT_EQ(parse_stop(text).text(), same);
  for (const char* wrong : {"gamma > 5 kPa", "p < much", "p <", "p = 3"})
    EXPECT_THROW((void)parse_stop(wrong), InputError);
}

TEST_F(ElementPaths, RelativeTargetsAreChanges) {
  const PathLeg leg = path("test = 'path'\n[[stage]]\nrelative = true\neps_1 = 0.01\nsigma_2 = 'hold'\nsigma_3 = 5e3\n")
                          .stages[0]
                          .legs[0];
  MaterialPoint point{.stress = -100e3 * Sym<double>::identity()};
  point.F(0, 0) = 0.98;
  const LoadStep absolute = leg_from(leg, point, {});
  const auto target = [&](const char* name) {
    return std::ranges::find(absolute.conditions, name, &Condition::name)->target;
  };
  EXPECT_NEAR(target("eps_1"), 0.03, 1e-15);
  EXPECT_NEAR(target("sigma_2"), 100e3, 1e-9);
  EXPECT_NEAR(target("sigma_3"), 105e3, 1e-9);
}

TEST_F(ElementPaths, TellsWhereALegHasTooFewConditionsOrALimitIsNone) {
  const std::string start = "test = 'path'\n[[stage]]\neps_1 = 0.1\nsigma_2 = 'hold'\n";
  EXPECT_THAT(errors(start), HasSubstr("case.toml:3:9: stage.1.eps_1: a leg needs six conditions, and this one has 5"));
  EXPECT_THAT(errors(start + "sigma_3 = 1\neps_3 = 0\n"), HasSubstr("this one has 7"));
  EXPECT_THAT(errors(start + "sigma_3 = 1\nuntil = 'phi > 3'\n"),
              HasSubstr("case.toml:6:9: stage.1.until: unknown measure 'phi' (did you mean 'phi_mob'?)"));
  EXPECT_THAT(errors(start + "sigma_3 = 1\nuntil = 'soon'\n"), HasSubstr("such as \"p < 20 kPa\""));
  EXPECT_THAT(errors(start + "sigma_3 = 'keep'\n"),
              testing::EndsWith(
                  "case.toml:5:11: stage.1.sigma_3: \"keep\" is not a number with a unit; allowed: free, hold, or a "
                  "number in Pa, or a text with a unit (Pa, kPa, MPa, GPa, bar)"));
  EXPECT_EQ(errors(start + "sigma_3 = 'hold'\n"), "no error");
}

/// The keys of a hundred million tables would fill the memory.
TEST_F(ElementPaths, RefusesNumbersOfTablesBehindAGap) {
  const auto says = [&](const std::string& key) {
    CaseFile given = CaseFile::read(folder_.file("gap.toml", "test = 'path'\n[[stage]]\n[[stage.leg]]\neps_1 = 0.1\n"));
    given.override_with(key + "=0.1");
    try {
      (void)element_case(given, catalogue());
    } catch (const InputError& error) { return std::string(error.what()); }
    return std::string("no error");
  };
  for (const char* number : {"100000000", "99999999999999999999", "3", "0", "-1"})
    EXPECT_EQ(says("stage." + std::string(number) + ".eps_1"),
              "--set stage." + std::string(number) +
                  ".eps_1: there is no stage.2; allowed: numbers from 1 without a gap");
  EXPECT_THAT(says("stage.1.leg.100000000.eps_1"), HasSubstr("there is no stage.1.leg.2"));
  EXPECT_THAT(says("stage.2.eps_1"), HasSubstr("a leg needs six conditions"));
  std::string many = "test = 'path'\n";
  for (int i = 0; i < 1001; ++i) many += "[[stage]]\nrepeat = 1\n";
  EXPECT_THAT(errors(many), HasSubstr("case.toml:2003:10: stage.1001.repeat: is one of 1001; allowed: at most 1000"));
}

TEST_F(ElementPaths, PoreWaterStandsInTotalStressesAlone) {
  const ElementPath given = path("test = 'path'\n[specimen]\nwater_bulk_modulus = '2 GPa'\n[initial]\n"
                                 "sigma = ['150 kPa', '140 kPa', '130 kPa']\ntau_23 = 3e3\npore_pressure = '50 kPa'\n"
                                 "[[stage]]\nrelative = true\neps_1 = 0.01\nsigma_2 = 'hold'\np = 4e3\n");
  EXPECT_EQ(given.stress.m[0], -100e3) << "effective";
  EXPECT_EQ(given.stress.m[5], std::numbers::sqrt2 * 3e3);
  MaterialPoint point{.stress = given.stress};
  point.strain.m[0] = -1e-5; // 20 kPa of water
  EXPECT_NEAR(find_measure("u").at(point, given.water), 70e3, 1e-6);
  EXPECT_NEAR(find_measure("sigma_1").at(point, given.water), 170e3, 1e-6);
  EXPECT_NEAR(find_measure("sigma_2_plus_3").at(point, given.water), 310e3, 1e-6);
  EXPECT_NEAR(find_measure("p_eff").at(point, given.water), 90e3, 1e-6);
  EXPECT_EQ(find_measure("q").at(point, given.water), find_measure("q").of(point));
  const LoadStep leg = leg_from(given.stages[0].legs[0], point, given.water);
  const auto p = std::ranges::find(leg.conditions, "p", &Condition::name);
  EXPECT_NEAR(p->measure(point), 160e3, 1e-6);
  EXPECT_NEAR(p->target, 164e3, 1e-6);
  EXPECT_THAT(errors("test = 'path'\n[[stage]]\nu = 1\n"), HasSubstr("stage.1.u: unknown key"));
}

TEST_F(ElementPaths, SinesAndDeformationGradientsAreCheckedToo) {
  const std::string held = "test = 'path'\n[[stage]]\neps_1 = 'hold'\neps_2 = 'hold'\neps_3 = 'hold'\n";
  const PathLeg leg = path(held + "tau = 'hold'\ntau_swing = '5 kPa'\ntau_phase = 90\n").stages[0].legs[0];
  const auto tau = std::ranges::find(leg.prescriptions, "tau", [](const Prescription& p) { return p.measure->name; });
  EXPECT_EQ(tau->swing, 5e3);
  EXPECT_NEAR(tau->phase, std::numbers::pi / 2, 1e-15);
  EXPECT_THAT(errors(held + "tau_swing = 5e3\n"),
              HasSubstr("case.toml:6:13: stage.1.tau_swing: the leg does not prescribe tau"));
  const std::string given = "test = 'path'\n[[stage]]\ndeformation_gradient = ";
  const PathLeg whole = path(given + "[0.9, 0.1, 0, 0.2, 1, 0, 0, 0, 1]\n").stages[0].legs[0];
  EXPECT_TRUE(whole.prescriptions.empty());
  EXPECT_EQ((*whole.deformation)(1, 0), 0.2);
  EXPECT_THAT(errors(given + "[1, 0, 0]\n"), HasSubstr("stage.1.deformation_gradient: has 3 numbers; allowed: 9"));
  EXPECT_THAT(errors(given + "[-1, 0, 0, 0, 1, 0, 0, 0, 1]\n"), HasSubstr("determinant that is not positive"));
  EXPECT_THAT(errors(given + "[1, 0, 0, 0, 1, 0, 0, 0, 1]\ngamma = 0.1\n"), HasSubstr("also prescribes gamma"));
}

/// What would take hours, or all of the memory, is refused before it begins.
TEST_F(ElementPaths, RefusesPathsOfMoreRowsThanCanBeKept) {
  const std::string strains = "test = 'path'\n[[stage]]\neps_2 = 'hold'\neps_3 = 'hold'\n";
  const std::string cycles = "[[stage.leg]]\neps_1 = 0.1\n[[stage.leg]]\neps_1 = 0.0\n";
  EXPECT_THAT(errors(strains + "repeat = 1_000_000\n" + cycles),
              HasSubstr("case.toml:5:10: stage.1.repeat: the path has at least 4e+08 rows up to here; allowed: at most "
                        "1000000"));
  EXPECT_EQ(errors(strains + "repeat = 1_000_000\nuntil = 'p > 200 kPa'\n" + cycles), "no error") << "may end soon";
  EXPECT_EQ(errors(strains + "repeat = 1000\neps_1 = 0.1\n"), "no error") << "stands still from the second round on";
  const std::string fine = "[output]\nevery_strain = 1e-9\n";
  EXPECT_THAT(errors(strains + "eps_1 = 0.1\n" + fine), HasSubstr("output.every_strain: the path has at least 1e+08"));
  EXPECT_THAT(errors("test = 'triaxial'\n" + fine), HasSubstr("case.toml:3:16: output.every_strain: the path has at"));
}

TEST_F(ElementPaths, TheResolvedCaseIsAFixedPoint) {
  const CheckedCase once = checked("test = 'path'\n[[stage]]\neps_1 = 0.1\nsigma_2 = 'hold'\nsigma_3 = 'hold'\n");
  const std::string text = case_text(once.keys, once.values);
  const CheckedCase again = checked(text);
  EXPECT_EQ(case_text(again.keys, again.values), text);
  EXPECT_EQ(text.find("free\n"), std::string::npos);
}

/// Every example of a path in the documentation is one.
TEST_F(ElementPaths, ThoseOfTheDocumentationAreFitToRun) {
  const std::string text = file_content(SOURCE_DIR "/docs/howto/element_paths.md");
  int examples = 0;
  for (std::size_t at = text.find("```toml\n"); at != std::string::npos;
       at = text.find("```toml\n", at + 1), ++examples) {
    const std::size_t start = at + std::string("```toml\n").size();
    EXPECT_EQ(errors("test = 'path'\n" + text.substr(start, text.find("```", start) - start)), "no error");
  }
  EXPECT_EQ(examples, 7);
}

TEST(Vary, CrossesItsWishes) {
  const auto all = variants_of(CaseFile::empty(), variations_of({"a.x=1,2", "b=[1,2],[3,4]"}));
  std::vector<std::string> names;
  for (const Variant& variant : all) names.push_back(variant.name);
  EXPECT_THAT(names, ElementsAre("x=1,b=[1,2]", "x=1,b=[3,4]", "x=2,b=[1,2]", "x=2,b=[3,4]"));
  EXPECT_EQ(all[1].label, "x = 1, b = [3,4]");
  EXPECT_EQ(variants_of(CaseFile::empty(), {}).size(), 1U);
  for (const char* wrong : {"a", "a=", "=1"}) EXPECT_THROW((void)variation_of(wrong), InputError);
}

} // namespace
} // namespace riedel::test
