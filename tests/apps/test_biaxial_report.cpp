/// What a biaxial run reports when it is short, stopped, or has no band: missing values are not reported as zero.
#include "apps/biaxial/report.hpp"
#include "apps/biaxial/views.hpp"
#include "apps/kinds.hpp"
#include "apps/program.hpp"
#include "core/campaign/read_json.hpp"
#include "core/campaign/results_table.hpp"
#include "support/csv.hpp"

#include <gmock/gmock.h>
#include <thread>

namespace riedel::test {
namespace {

using nlohmann::ordered_json;
using testing::AllOf;
using testing::ContainsRegex;
using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;

class BiaxialReport : public testing::Test {
protected:
  [[nodiscard]] Outcome run_into(const std::string& name, const Words& more) const {
    Words settings{"--set", "output.plots=false", "--set", "output.vtk=false"};
    settings.insert(settings.end(), more.begin(), more.end());
    return run(folder_, coarse_case(folder_ / name, settings));
  }
  [[nodiscard]] ordered_json summary(const std::string& name) const {
    return read_json(folder_ / name / "summary.json");
  }
  TemporaryFolder folder_;
};

std::vector<std::string> nulls_of(const ordered_json& json) {
  std::vector<std::string> names;
  for (const auto& [key, value] : json.items())
    if (value.is_null()) names.push_back(key);
  return names;
}

TEST_F(BiaxialReport, OfAShortRunLeavesOutWhatItCannotHave) {
  const Outcome outcome = run_into("out", {"--set", "loading.final_strain=0.001"});
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  const ordered_json s = summary("out");
  EXPECT_THAT(nulls_of(s),
              testing::UnorderedElementsAre("phi_residual_deg", "kinetic_over_internal_max", "quasi_static"));
  EXPECT_THAT(nulls_of(s["band"]),
              testing::IsSupersetOf({"inclination_deg", "thickness_m", "thickness_fwhm_m", "thickness_rate_m",
                                     "thickness_over_lc", "void_ratio_inside", "conjugate_ratio"}));
  EXPECT_THAT(outcome.out, AllOf(ContainsRegex("peak .* still rising where the run ends\n"), HasSubstr("residual   - "),
                                 HasSubstr("shear band none\n"), Not(HasSubstr("0.00 mm"))));
}

/// The residual angle is that of the last 1 % of u/h0, if the run ends at least 1 % after the peak.
TEST_F(BiaxialReport, HasAResidualAngleOnePercentPastThePeak) {
  const Words fast{"--set", "loading.speed=2", "--set", "nonlocal.length=0", "--set", "imperfection.size=[0,0]"};
  const auto run_to = [&](const std::string& name, const std::string& strain) {
    Words words = fast;
    words.insert(words.end(), {"--set", "loading.final_strain=" + strain});
    EXPECT_EQ(run_into(name, words).code, 0);
    return summary(name);
  };
  const ordered_json before = run_to("short", "0.02"), past = run_to("long", "0.04");
  const double peak = past["u_over_h_at_peak"];
  ASSERT_GT(peak, 0.01);
  ASSERT_LT(peak, 0.03);
  EXPECT_EQ(before["phi_residual_deg"].is_null(), 0.02 - peak < 0.01);
  const Table history = read_csv((folder_ / "long" / "history.csv").string());
  double sum = 0.0, rows = 0.0;
  const auto &u = history.at("u_over_h"), &phi = history.at("phi_mob_deg");
  for (std::size_t i = 0; i < u.size(); ++i)
    if (u[i] > u.back() - 0.01) sum += phi[i], ++rows;
  EXPECT_NEAR(past["phi_residual_deg"].get<double>(), sum / rows, 1e-9);
}

TEST_F(BiaxialReport, OfAnInterruptedRunSaysHowFarItCame) {
  Process process(folder_,
                  coarse_case(folder_ / "out", {"--set", "loading.speed=0.01", "--set", "loading.final_strain=0.5",
                                                "--set", "output.every_strain=1e-5", "--set", "output.plots=false"}));
  while (process.running() && file_content(folder_ / "out" / "history.csv").size() < 2000)
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  const Outcome outcome = process.finish(SIGTERM);
  EXPECT_EQ(outcome.code, 143);
  const ordered_json s = summary("out");
  EXPECT_TRUE(s["phi_residual_deg"].is_null()) << "it did not come to its final strain";
  const std::string share = short_text(100.0 * s["u_over_h"].get<double>() / 0.5);
  EXPECT_THAT(outcome.out, AllOf(StartsWith("interrupted at u/h0 = "), HasSubstr(" %, " + share + " % of the case\n"),
                                 HasSubstr("residual   - ")));
}

TEST_F(BiaxialReport, OfAFailedRunSaysHowFarItCameAndKeepsItsFigures) {
  const Outcome outcome = run_into("out", {"--set", "time.step=5e-5", "--set", "loading.final_strain=0.02"});
  EXPECT_EQ(outcome.code, 3);
  EXPECT_THAT(outcome.out, AllOf(StartsWith("failed at u/h0 = "), HasSubstr(" % of the case\n"),
                                 HasSubstr("residual   - "), HasSubstr("shear band -\n")));
  const ordered_json s = summary("out");
  EXPECT_EQ(s["status"], "failed");
  EXPECT_GT(s["steps"], 0);
  EXPECT_GT(s["u_over_h"], 0.0);
  EXPECT_TRUE(s["phi_residual_deg"].is_null());
  EXPECT_EQ(nulls_of(s["band"]).size(), s["band"].size());
}

/// Two specimens that differ by a thousandth: in both the zone of a long l_c is as wide as it is long.
TEST_F(BiaxialReport, TellsADiffuseZoneOfSpecimensThatAreNearlyAlike) {
  for (const char* void_ratio : {"0.549", "0.55", "0.551"}) {
    const Words words{"--set", "grid.cells=[12,42]",
                      "--set", "nonlocal.length=4e-3",
                      "--set", "loading.speed=0.5",
                      "--set", "loading.final_strain=0.035",
                      "--set", std::string("specimen.void_ratio=") + void_ratio};
    const Outcome outcome = run_into(void_ratio, words);
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    const ordered_json band = summary(void_ratio)["band"];
    EXPECT_EQ(band["kind"], "diffuse") << band;
    EXPECT_FALSE(band["found"]);
    EXPECT_GT(band["thickness_fwhm_m"], 15e-3);
    EXPECT_THAT(outcome.out, HasSubstr("shear band diffuse, inclined "));
  }
}

RunResult result_with(const ordered_json& band) {
  RunResult result{.name = "one", .label = "one", .settings = {}, .folder = {}, .status = RunStatus::done};
  result.summary = {
      {"phi_peak_deg", 50.0}, {"u_over_h_at_peak", 0.01}, {"phi_residual_deg", nullptr}, {"wall_s", 1.0}, {"steps", 10},
      {"band", band}};
  return result;
}

TEST(Tables, ShowADashOrAnEmptyCellForWhatIsNull) {
  const std::vector<RunResult> runs{result_with({{"found", false},
                                                 {"kind", "none"},
                                                 {"doubt", nullptr},
                                                 {"inclination_deg", nullptr},
                                                 {"thickness_over_lc", nullptr}}),
                                    result_with({{"found", true},
                                                 {"kind", "single"},
                                                 {"doubt", "its widths differ"},
                                                 {"inclination_deg", 55.0},
                                                 {"thickness_over_lc", nullptr}})};
  EXPECT_THAT(results_csv(runs), HasSubstr("\none,done,,50.0,0.01,,1.0,10,false,none,,,\n"));
  EXPECT_THAT(results_text(run_kind("biaxial"), runs), HasSubstr("residual - deg, no band"));
  const PageTable table = band_table(runs);
  for (std::size_t c = 5; c < table.header.size(); ++c) EXPECT_EQ(table.rows[0].cells[c].text, "–") << table.header[c];
  EXPECT_EQ(table.rows[0].cells[3].text, "–") << "residual angle";
  EXPECT_EQ(table.rows[1].cells[4].text, "single, doubtful");
  EXPECT_EQ(table.rows[1].cells[5].text, "55.0");
}

TEST(BiaxialText, HasNoFigureForARunThatHasNotBegun) {
  const ordered_json s{
      {"status", "interrupted"},     {"u_over_h", 0.0}, {"final_strain", 0.06}, {"phi_peak_deg", nullptr},
      {"u_over_h_at_peak", nullptr}, {"wall_s", 0.1},   {"band", nullptr}};
  EXPECT_THAT(biaxial_text(s),
              AllOf(StartsWith("interrupted at u/h0 = 0.000 %, 0 % of the case\npeak       - at"),
                    HasSubstr("residual   - "), HasSubstr("shear band -\n"), HasSubstr("time       0.1 s, -\n")));
}

} // namespace
} // namespace riedel::test
