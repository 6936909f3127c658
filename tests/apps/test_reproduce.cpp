/// `riedel reproduce`, and the theory that it compares with the runs.
#include "apps/program.hpp"
#include "apps/reproduce/band_theory.hpp"
#include "apps/reproduce/statement_text.hpp"
#include "materials/element/bifurcation.hpp"
#include "materials/gudehus_bauer.hpp"
#include "support/csv.hpp"

#include <gmock/gmock.h>

namespace riedel::test {
namespace {

namespace fs = std::filesystem;
using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

HomogeneousTest homogeneous(double void_ratio) {
  return homogeneous_test(Values(GudehusBauer::parameters()), void_ratio, 50e3, 0.05);
}

TEST(HomogeneousTest, MeetsTheReferenceCurves) {
  for (const auto& [void_ratio, file] : {std::pair{0.55, "gudehus_bauer_planestrain_e0.55_p50kPa.csv"},
                                         {0.75, "gudehus_bauer_planestrain_e0.75_p50kPa.csv"}}) {
    const HomogeneousTest ours = homogeneous(void_ratio);
    const Table wanted = reference(file);
    for (std::size_t i = 1; i < wanted.at("u_h0").size(); ++i) {
      const double strain = wanted.at("u_h0")[i];
      if (strain > ours.u_over_h.back()) break;
      EXPECT_NEAR(interpolate(ours.u_over_h, ours.angle, strain), wanted.at("phi_mob_deg")[i], 0.01) << strain;
      EXPECT_NEAR(interpolate(ours.u_over_h, ours.void_ratio, strain), wanted.at("e")[i], 1e-5) << strain;
    }
  }
}

/// Independent values for the linear solid: onset between 1.1 and 1.3 %, bands at 63.5° and 52.1°.
TEST(HomogeneousTest, FindsWhereABandBecomesPossible) {
  const HomogeneousTest dense = homogeneous(0.55), medium = homogeneous(0.75);
  EXPECT_NEAR(dense.peak_angle, 59.10, 0.01);
  EXPECT_NEAR(dense.peak_u_over_h, 0.0146, 1e-4);
  EXPECT_NEAR(dense.linear.u_over_h, 0.0130, 1e-4);
  EXPECT_NEAR(dense.linear.inclination_deg, 63.5, 0.3);
  EXPECT_NEAR(medium.linear.inclination_deg, 52.1, 0.3);
  for (const HomogeneousTest& test : {dense, medium}) {
    EXPECT_GT(test.nonlinear.u_over_h, 0.010);
    EXPECT_LT(test.nonlinear.u_over_h, test.linear.u_over_h)
        << "a jump of any size needs less than an infinitesimal one";
    EXPECT_LT(test.linear.u_over_h, test.peak_u_over_h);
  }
}

TEST(BandTheory, MeetsTheClosedFormsOfTheCriticalState) {
  EXPECT_NEAR(plane_strain_critical_angle(30.0), 34.345, 5e-4);
  const Table wanted = reference("residual_angle_vs_band_inclination.csv");
  for (std::size_t i = 0; i < wanted.at("theta_deg").size(); ++i)
    EXPECT_NEAR(residual_angle(30.0, wanted.at("theta_deg")[i]), wanted.at("phi_global_deg")[i], 1e-4);
  EXPECT_NEAR(outer_angle(traction_ratio(41.0, 57.0), 57.0), 41.0, 1e-12);
}

TEST(BandTheory, FollowsTheOneDimensionalBandOfTheReference) {
  const Table wanted = reference("band1d_e0.55_theta55_lc1.5mm.csv");
  for (std::size_t i = 0; i < wanted.at("u_h0").size(); ++i) {
    const double strain = wanted.at("u_h0")[i];
    const BandState band = band_1d(strain);
    EXPECT_NEAR(band.angle, wanted.at("phi_global_deg")[i], strain < 0.01 ? 2.0 : strain < 0.03 ? 0.5 : 0.1) << strain;
    EXPECT_NEAR(band.inclination_deg, wanted.at("theta_deg")[i], 0.02) << strain;
    if (strain > 0.03) {
      EXPECT_NEAR(band.thickness_e, wanted.at("width_e_gt_0.70_m")[i], 1.2e-3) << "its cells are 0.5 mm";
      EXPECT_NEAR(band_1d_angle(strain, band.inclination_deg), band.angle, 1e-9);
    }
  }
  EXPECT_NEAR(band_1d(0.05).thickness_rate, 5.24e-3, 1e-5);
}

TEST(Statements, AreDecidedByWhatIsThere) {
  const double missing = std::nan("");
  EXPECT_EQ(within(55.5, 55.0, 1.0), Verdict::agrees);
  EXPECT_EQ(within(57.0, 55.0, 1.0), Verdict::differs);
  EXPECT_EQ(within(57.0, 55.0, 1.0, Verdict::cannot_hold), Verdict::cannot_hold);
  EXPECT_EQ(within(missing, 55.0, 1.0), Verdict::open);
  EXPECT_EQ(rising({1.0, missing, 2.0, 1.95, 3.0}, 0.1), Verdict::agrees);
  EXPECT_EQ(rising({1.0, 2.0, 1.5}, 0.1), Verdict::differs);
  EXPECT_EQ(rising({1.0, missing, 2.0}, 0.1), Verdict::open);
  const Statement first{.where = "a|b", .claim = "c", .measured = "1", .theory = "t", .reason = "r"};
  EXPECT_THAT(statement_markdown({{"", {first}}}), HasSubstr("\n| a\\|b | c | open | 1 | t | r |"));
}

TEST(Statements, OfTwoWaysStandSideBySide) {
  const Statement first{.where = "a", .claim = "c", .measured = "1", .theory = "t", .reason = "r"};
  Statement second = first;
  second.measured = "2", second.verdict = Verdict::agrees, second.reason = "";
  const std::vector<Verdicts> both{{"one way", {first}}, {"another", {second}}};
  EXPECT_EQ(statement_markdown(both),
            "| where | the paper says | one way | measured | another | measured | theory | reason |\n"
            "|---|---|---|---|---|---|---|---|\n| a | c | open | 1 | agrees | 2 | t | r |\n");
  EXPECT_THAT(statement_text(both), AllOf(HasSubstr("a: c\n"), HasSubstr("open       1, one way\n"),
                                          HasSubstr("agrees     2, another\n"), HasSubstr("theory: t\n")));
}

TEST(BandTheory, HasTheInclinationsThatTestsAreComparedWith) {
  const BandAngles angles = band_angles(55.0, 20.0);
  EXPECT_DOUBLE_EQ(angles.roscoe, 55.0);
  EXPECT_DOUBLE_EQ(angles.arthur, 63.75);
  EXPECT_DOUBLE_EQ(angles.coulomb, 72.5);
}

/// Sand unloads stiffly: after unloading from the peak most of the strain remains.
TEST(HomogeneousTest, UnloadsFromWhereTheBandTakesOver) {
  const Unloading path = unloading_after(Values(GudehusBauer::parameters()), 0.55, 50e3, 0.0139);
  EXPECT_NEAR(path.u_over_h.front(), 0.0139, 2e-5);
  EXPECT_NEAR(path.angle.front(), 59.07, 0.1);
  EXPECT_TRUE(std::ranges::is_sorted(path.angle, std::greater{}));
  const double at_33 =
      interpolate({path.angle.rbegin(), path.angle.rend()}, {path.u_over_h.rbegin(), path.u_over_h.rend()}, 33.0);
  EXPECT_GT(at_33, 0.007);
  EXPECT_LT(at_33, 0.0125);
}

class Reproduce : public testing::Test {
protected:
  [[nodiscard]] Outcome reproduce(const Words& more) const {
    Words words{"reproduce", "--out", out_.string()};
    words.insert(words.end(), more.begin(), more.end());
    return run(folder_, words);
  }
  TemporaryFolder folder_;
  fs::path out_ = folder_ / "out";
};

TEST_F(Reproduce, DrawsTheElementTestsAndPutsTheVerdictIntoADocument) {
  const std::string document =
      folder_.file("paper.md", "# Paper\n<!-- riedel reproduce -->\nold\n<!-- riedel reproduce ends -->\nend\n");
  const Outcome outcome = reproduce({"--figure", "2,5", "--document", document});
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_THAT(outcome.out, AllOf(HasSubstr("Figs. 2–5"), HasSubstr("  agrees     triaxial, 500 kPa"),
                                 HasSubstr("figure_2a.png, figure_2b.png, figure_5a_200.png")));
  EXPECT_THAT(file_content(out_ / "figure_2b.png"), testing::StartsWith("\x89PNG"));
  EXPECT_FALSE(fs::exists(out_ / "figure_3.png"));
  EXPECT_THAT(file_content(document),
              AllOf(HasSubstr("# Paper\n"), HasSubstr("| agrees |"), Not(HasSubstr("old")), HasSubstr("end\n")));
  EXPECT_THAT(file_content(out_ / "report.html"),
              AllOf(HasSubstr("<h2>Figure 2</h2>"), HasSubstr("class=\"text agrees\">agrees")));
}

TEST_F(Reproduce, RunsAFigureAndLeavesOpenWhatTheRunsDoNotReach) {
  const Words words{"--figure", "10",
                    "--set",    "loading.final_strain=0.002",
                    "--set",    "loading.speed=0.5",
                    "--set",    "loading.ramp_time=1e-3"};
  const Outcome outcome = reproduce(words);
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_THAT(outcome.out,
              AllOf(HasSubstr("e₀ 0.75: peak 40°"), HasSubstr("Fig. 10: e₀ 0.75: θ = 50°\n  open"),
                    HasSubstr("figure_10a.png"), HasSubstr("figure_10a_filtered.png"), HasSubstr("figure_10c.png")));
  for (const char* name : {"24x84", "e0=0.75", "e0=0.90", "24x84,filtered", "e0=0.90,filtered"})
    EXPECT_TRUE(fs::exists(out_ / name / "summary.json")) << name;
  const auto kept = fs::last_write_time(out_ / "24x84" / "summary.json");
  EXPECT_EQ(reproduce(words).code, 0);
  EXPECT_EQ(fs::last_write_time(out_ / "24x84" / "summary.json"), kept) << "what has run does not run again";
  const std::string as_run = file_content(out_ / "24x84,filtered" / "case.toml");
  EXPECT_THAT(as_run, AllOf(HasSubstr("scheme = \"cpdi\""), HasSubstr("speed = 0.5"), HasSubstr("damping = \"auto\"")))
      << "what a user sets comes last";
  EXPECT_THAT(file_content(out_ / "24x84" / "case.toml"),
              AllOf(HasSubstr("scheme = \"gimp\""), HasSubstr("flip = 0.98"), HasSubstr("stress_filter = 0")));
  EXPECT_THAT(reproduce({"--figure", "9"}).err, HasSubstr("holds another campaign"));
}

TEST_F(Reproduce, SaysWhatIsWrong) {
  EXPECT_THAT(reproduce({"--figure", "6"}).err, HasSubstr("--figure 6: unknown"));
  EXPECT_THAT(reproduce({"--way", "slow"}).err, HasSubstr("--way slow: unknown"));
  EXPECT_THAT(reproduce({"--scheme", "gimpo"}).err, HasSubstr("--scheme gimpo: unknown (did you mean 'gimp'?)"));
  EXPECT_THAT(reproduce({"--set", "specimen.wdth=1"}).err, HasSubstr("did you mean 'specimen.width'?"));
  const std::string document = folder_.file("none.md", "nothing\n");
  EXPECT_THAT(reproduce({"--document", document}).err, HasSubstr("<!-- riedel reproduce -->"));
  EXPECT_FALSE(fs::exists(out_));
}

} // namespace
} // namespace riedel::test
