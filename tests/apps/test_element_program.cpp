/// `riedel element` as a user runs it.
#include "apps/program.hpp"
#include "core/io/table.hpp"
#include "core/png_pixels.hpp"
#include "support/csv.hpp"
#include "support/patterns.hpp"

#include <algorithm>
#include <gmock/gmock.h>
#include <nlohmann/json.hpp>
#include <set>

namespace riedel::test {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;
using testing::AllOf;
using testing::HasSubstr;
using testing::IsSupersetOf;
using testing::StartsWith;

class ElementProgram : public testing::Test {
protected:
  /// `riedel element` with results in a folder of that name.
  [[nodiscard]] Outcome element(const std::string& name, const Words& words) const {
    Words all{"element"};
    all.insert(all.end(), words.begin(), words.end());
    all.insert(all.end(), {"--out", (folder_ / name).string()});
    return run(folder_, all);
  }
  [[nodiscard]] json summary(const std::string& name) const { return json_of(folder_ / name / "summary.json"); }
  [[nodiscard]] riedel::Table curve(const std::string& name) const {
    return read_table(folder_ / name / "element.csv");
  }
  TemporaryFolder folder_;
};

/// Compares a reference curve with the computed one, interpolated linearly between rows at every strain of the
/// reference but the first.
void expect_on(const riedel::Table& ours, const std::string& strain, const Table& wanted,
               const std::string& wanted_strain, const std::string& wanted_angle) {
  const auto& x = wanted.at(wanted_strain);
  for (std::size_t i = 1; i < x.size() && x[i] <= ours[strain].back(); ++i) {
    EXPECT_NEAR(interpolate(ours[strain], ours["void_ratio"], x[i]), wanted.at("e")[i], 1e-5) << x[i];
    EXPECT_NEAR(interpolate(ours[strain], ours["sigma_1_Pa"], x[i]) / wanted.at("sig11_Pa")[i], 1.0, 1e-3) << x[i];
    if (!wanted_angle.empty()) {
      EXPECT_NEAR(interpolate(ours[strain], ours["phi_mob_deg"], x[i]), wanted.at(wanted_angle)[i], 0.005) << x[i];
    }
  }
}

TEST_F(ElementProgram, MeetsTheReferenceWithoutACaseFile) {
  ASSERT_EQ(element("triaxial", {"triaxial", "--set", "output.plots=false"}).code, 0);
  expect_on(curve("triaxial"), "eps_1", reference("gudehus_bauer_triaxial_e0.60_p500kPa.csv"), "u_h0", "phi_mob_deg");
  ASSERT_EQ(element("biaxial", {"biaxial"}).code, 0);
  expect_on(curve("biaxial"), "eps_1", reference("gudehus_bauer_planestrain_e0.55_p50kPa.csv"), "u_h0", "phi_mob_deg");
  ASSERT_EQ(element("loose", {"biaxial", "--set", "specimen.void_ratio=0.9"}).code, 0); // σ_3 falls below σ_2 there
  expect_on(curve("loose"), "eps_1", reference("gudehus_bauer_planestrain_e0.90_p50kPa.csv"), "u_h0", "phi_mob_deg");
  ASSERT_EQ(element("shear", {"shear"}).code, 0);
  expect_on(curve("shear"), "gamma", reference("gudehus_bauer_simpleshear_e0.60_sn200kPa.csv"), "gamma_u_h0",
            "phi_atan_deg");
  ASSERT_EQ(element("oedometer", {"oedometer"}).code, 0);
  expect_on(curve("oedometer"), "eps_1", reference("gudehus_bauer_oedometer_e0.60_iso1kPa.csv"), "eps11_eng", "");
}

TEST_F(ElementProgram, LeavesThePromisedColumnsAndKeys) {
  const Outcome outcome = element("out", {"triaxial"});
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_THAT(outcome.out, StartsWith("peak 38.50 deg at eps_1 = 4.9"));
  EXPECT_THAT(file_content(folder_ / "out" / "element.csv"),
              StartsWith("eps_1,eps_2,eps_3,gamma,sigma_1_Pa,sigma_2_Pa,sigma_3_Pa,tau_Pa,void_ratio,phi_mob_deg,"
                         "time_s,stage,cycle,p_Pa,q_Pa\n"));
  const json s = summary("out");
  const riedel::Table table = curve("out");
  EXPECT_EQ(s["status"], "done");
  EXPECT_EQ(s["test"], "triaxial");
  EXPECT_EQ(s["phi_peak_deg"], *std::ranges::max_element(table["phi_mob_deg"]));
  EXPECT_EQ(s["phi_final_deg"], table["phi_mob_deg"].back());
  EXPECT_EQ(s["void_ratio_final"], table["void_ratio"].back());
  EXPECT_NEAR(s["eps_1_at_peak"].get<double>(), 0.0498, 0.0005); // rows stand 0.0009 apart
  EXPECT_NEAR(table["eps_1"].back(), 0.3, 1e-9);
  for (const char* picture : {"stress_strain.png", "friction.png", "void_ratio.png", "compression.png", "p_q.png"})
    EXPECT_GT(PngPixels(folder_ / "out" / picture).width(), 300) << picture;
  ASSERT_EQ(element("shear", {"shear", "--set", "output.plots=false"}).code, 0);
  EXPECT_EQ(curve("shear").names[10], "phi_principal_deg");
  EXPECT_FALSE(fs::exists(folder_ / "shear" / "friction.png"));
}

TEST_F(ElementProgram, ItsOwnCaseGivesTheSameBitsAgain) {
  const std::string path = folder_.file("path.toml", "[specimen]\nvoid_ratio = 0.7\n[[stage]]\nrepeat = 2\nuntil = "
                                                     "'p < 60 kPa'\neps_1 = 'hold'\neps_2 = 'hold'\neps_3 = 'hold'\n"
                                                     "[[stage.leg]]\ntau = '10 kPa'\n[[stage.leg]]\ntau = -10e3\n");
  ASSERT_EQ(element("first", {"path", path}).code, 0);
  ASSERT_EQ(element("again", {"path", (folder_ / "first" / "case.toml").string()}).code, 0);
  auto first = files_in(folder_ / "first"), again = files_in(folder_ / "again");
  for (auto* files : {&first, &again}) files->erase("summary.json"); // holds the time it took
  EXPECT_EQ(first, again);
  EXPECT_GT(first["element.csv"].size(), 3000U);
}

TEST_F(ElementProgram, VariesKeysInAFolderEachAndDrawsThemTogether) {
  const Outcome outcome = element("out", {"triaxial", "--vary", "specimen.void_ratio=0.6,0.9", "--vary",
                                          "loading.confining_pressure=50e3,5e5", "--set", "loading.final_strain=0.02"});
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  std::set<std::string> names;
  for (const auto& [name, content] : files_in(folder_ / "out")) names.insert(name);
  for (const char* variant : {"void_ratio=0.6,confining_pressure=50e3", "void_ratio=0.6,confining_pressure=5e5",
                              "void_ratio=0.9,confining_pressure=50e3", "void_ratio=0.9,confining_pressure=5e5"})
    for (const char* file : {"case.toml", "element.csv", "summary.json"})
      EXPECT_TRUE(names.contains(std::string(variant) + "/" + file)) << variant;
  EXPECT_TRUE(names.contains("friction.png"));
  EXPECT_EQ(names.size(), 4U * 3U + 5U);
  EXPECT_EQ(curve("out/void_ratio=0.9,confining_pressure=50e3")["sigma_2_Pa"].front(), 50e3);
  EXPECT_EQ(element("none", {"triaxial", "--vary", "specimen.void_ratio"}).code, 2);
}

TEST_F(ElementProgram, ShowsAMeasuredCurveAndRefusesOneThatIsNone) {
  const std::string measured = folder_.file("measured.csv", "eps_1,phi_mob_deg\n0,0\n0.05,38\n0.2,33\n");
  const Words shorter{"triaxial", "--set", "loading.final_strain=0.2"};
  const auto with = [&](const std::string& file) {
    Words words = shorter;
    words.insert(words.end(), {"--reference", file});
    return words;
  };
  ASSERT_EQ(element("without", shorter).code, 0);
  ASSERT_EQ(element("with", with(measured)).code, 0);
  const auto picture = [&](const char* folder, const char* name) { return file_content(folder_ / folder / name); };
  EXPECT_NE(picture("with", "friction.png"), picture("without", "friction.png"));
  EXPECT_EQ(picture("with", "void_ratio.png"), picture("without", "void_ratio.png")); // no such column

  const std::string text = folder_.file("text.csv", "eps_1,phi_mob_deg\n0,0\n0.05,many\n"),
                    other = folder_.file("other.csv", "eps_1,force\n0,0\n");
  EXPECT_THAT(element("a", with(text)).err, HasSubstr(text + ":3:6: 'many' in column phi_mob_deg is not a number"));
  EXPECT_THAT(element("b", with(other)).err, AllOf(HasSubstr(other + ":1:1"), HasSubstr("eps_1 and phi_mob_deg")));
  EXPECT_EQ(element("c", with(other)).code, 2);
  EXPECT_FALSE(fs::exists(folder_ / "c"));
}

TEST_F(ElementProgram, StopsAtAnImpossibleControlWithWhatWasReached) {
  const std::string path =
      folder_.file("path.toml", "[[stage]]\nname = 'too much'\nsigma_1 = '2 MPa'\nsigma_2 = 'hold'\n"
                                "sigma_3 = 'hold'\n");
  const Outcome outcome = element("out", {"path", path});
  EXPECT_EQ(outcome.code, 3);
  EXPECT_THAT(outcome.err, AllOf(StartsWith("riedel: error: too much: "), HasSubstr("sigma_1"),
                                 HasSubstr("eps_1 = 0.0"), HasSubstr("limit state")));
  const json s = summary("out");
  EXPECT_EQ(s["status"], "failed");
  EXPECT_THAT(outcome.err, HasSubstr(s["reason"].get<std::string>()));
  EXPECT_GT(curve("out")["eps_1"].back(), 0.01);
  ASSERT_EQ(element("strain", {"triaxial", "--set", "loading.confining_pressure=100e3"}).code, 0);
  EXPECT_NEAR(s["phi_final_deg"].get<double>(), summary("strain")["phi_peak_deg"].get<double>(), 0.1);
  EXPECT_TRUE(fs::exists(folder_ / "out" / "friction.png"));
}

TEST_F(ElementProgram, RefusesAStartThatTheLawDoesNotKnow) {
  EXPECT_THAT(element("a", {"triaxial", "--set", "specimen.void_ratio=0.3"}).err,
              HasSubstr("--set specimen.void_ratio: 0.3 is out of range; the law allows (0.4666, 1.189] at the "
                        "confining pressure"));
  EXPECT_THAT(element("b", {"oedometer", "--set", "loading.initial_pressure=-5"}).err,
              HasSubstr("--set loading.initial_pressure: -5 is out of range"));
  EXPECT_THAT(element("c", {"oedometer", "--set", "loading.initial_pressure=5"}).err,
              HasSubstr("must exceed 10.0 Pa (material.minimum_pressure)"));
  EXPECT_EQ(element("f", {"oedometer", "--set", "loading.initial_pressure=5", "--set", "loading.final_strain=0.001",
                          "--set", "material.cohesion_pressure=100"})
                .code,
            0);
  EXPECT_THAT(
      element("g", {"triaxial", "--set", "specimen.void_ratio=1.185", "--set", "material.cohesion_pressure=100e3"}).err,
      HasSubstr("the law allows (0.4"));
  EXPECT_THAT(element("d", {"path", "--set", "initial.sigma=[-1,2,3]"}).err, HasSubstr("initial.sigma: [-1, 2, 3]"));
  EXPECT_EQ(element("e", {"triaxial", "--set", "specimen.void_ratio=0.3"}).code, 2);
  EXPECT_FALSE(fs::exists(folder_ / "e"));
}

TEST_F(ElementProgram, RefusesWhatItDoesNotKnow) {
  for (const Words& words : {Words{}, {"triaxal"}, {"triaxial", "--driver", "fem"}, {"path"}, {"triaxial", "a", "b"}})
    EXPECT_EQ(element("out", words).code, 2);
  const std::string shear = folder_.file("shear.toml", "test = 'shear'\n");
  EXPECT_THAT(element("out", {"triaxial", shear}).err,
              HasSubstr(shear + ":1:8: test: is \"shear\", and the command asks for triaxial"));
  EXPECT_FALSE(fs::exists(folder_ / "out"));
}

TEST_F(ElementProgram, RunsASpecimenOfCellsAsWell) {
  ASSERT_EQ(element("cells", {"biaxial", "--driver", "mpm", "--set", "scheme=cpdi", "--set", "grid.cells=2"}).code, 0);
  const json s = summary("cells");
  EXPECT_EQ(s["driver"], "mpm");
  EXPECT_NEAR(s["phi_peak_deg"].get<double>(), 59.09, 0.05);
  for (const char* key : {"kinetic_J", "internal_J", "external_J", "kinetic_over_internal_max", "stress_spread_max"})
    EXPECT_GT(s[key].get<double>(), 0.0) << key;
  ASSERT_EQ(element("again", {"biaxial", (folder_ / "cells" / "case.toml").string()}).code, 0);
  EXPECT_EQ(file_content(folder_ / "cells" / "element.csv"), file_content(folder_ / "again" / "element.csv"));
  ASSERT_EQ(element("point", {"biaxial"}).code, 0);
  EXPECT_FALSE(summary("point").contains("kinetic_J")) << "a point has no mass";
}

TEST_F(ElementProgram, RefusesASpecimenThatATestCannotHave) {
  const auto says = [&](const Words& words) {
    Outcome outcome = element("none", words);
    EXPECT_EQ(outcome.code, 2);
    return outcome.err;
  };
  const std::string path = folder_.file("path.toml", "[[stage]]\neps_1 = 0.01\neps_2 = 'hold'\neps_3 = 'hold'\n");
  EXPECT_THAT(says({"path", path, "--driver", "mpm"}), HasSubstr("cannot run a path"));
  EXPECT_THAT(says({"triaxial", "--driver", "mpm", "--set", "grid.dimensions=2"}), HasSubstr("allowed: 3"));
  EXPECT_THAT(says({"biaxial", "--driver", "mpm", "--set", "grid.dimensions=2.5"}), HasSubstr("allowed: 2, 3"));
  EXPECT_THAT(says({"biaxial", "--driver", "mpm", "--set", "scheme=sinc"}), HasSubstr("cpdi"));
  EXPECT_THAT(says({"biaxial", "--driver", "fem"}), HasSubstr("mpm"));
  EXPECT_THAT(says({"triaxial", "--driver", "mpm", "--set", "grid.cells=1000"}),
              HasSubstr("--set grid.cells: 1000.0 along each edge make 8e+09 points; allowed: at most"));
  EXPECT_THAT(says({"biaxial", "--driver", "mpm", "--set", "loading.speed=1e-12"}),
              HasSubstr("loading.speed: 1e-12 m/s makes about"));
}

TEST_F(ElementProgram, RefusesAnIntergranularStrainThatTheLawCannotHave) {
  const std::string path = folder_.file("path.toml", "[initial]\nintergranular_strain = [3e-4, 0, 0]\n[[stage]]\n"
                                                     "eps_1 = 0.01\neps_2 = 'hold'\neps_3 = 'hold'\n");
  const Outcome without = element("none", {"path", path});
  EXPECT_EQ(without.code, 2);
  EXPECT_THAT(without.err, AllOf(HasSubstr("path.toml:2"), HasSubstr("has no intergranular strain")));
  const Outcome beyond = element("none", {"path", path, "--set", "material.intergranular_strain=true"});
  EXPECT_EQ(beyond.code, 2);
  EXPECT_THAT(beyond.err, HasSubstr("allowed: at most R = 0.0001"));
}

TEST_F(ElementProgram, KeepsResultsUnlessForced) {
  const Words words{"oedometer", "--set", "output.plots=false"};
  ASSERT_EQ(element("out", words).code, 0);
  EXPECT_THAT(element("out", words).err, HasSubstr("holds results already"));
  Words forced = words;
  forced.push_back("--force");
  EXPECT_EQ(element("out", forced).code, 0);
}

TEST_F(ElementProgram, ChecksItsCasesToo) {
  const std::string path = folder_.file("path.toml", "test = 'path'\n[[stage]]\neps_1 = 0.1\nsigma_2 = 'hold'\n");
  const Outcome outcome = run(folder_, {"check", path});
  EXPECT_EQ(outcome.code, 2);
  EXPECT_THAT(outcome.err, HasSubstr(path + ":3:9: stage.1.eps_1: a leg needs six conditions, and this one has 5"));
  EXPECT_THAT(run(folder_, {"check", "--set", "test=shear"}).out, HasSubstr("normal_stress = 200000.0"));
  const json schema = parsed(run(folder_, {"check", "--schema", "--set", "test=path"}).out);
  EXPECT_TRUE(schema["properties"]["stage"]["items"]["properties"]["leg"]["items"]["properties"].contains("tau"));
}

TEST_F(ElementProgram, FiltersStressesOfASpecimenWhenItIsAskedTo) {
  Words words{"oedometer",
              "--driver",
              "mpm",
              "--set",
              "loading.final_strain=0.002",
              "--set",
              "output.plots=false",
              "--set",
              "time.stress_filter_order=8"};
  const Outcome without = element("without", words);
  EXPECT_EQ(without.code, 2);
  EXPECT_THAT(without.err, HasSubstr("8 means nothing to a filter without a rate"));
  words.insert(words.end(), {"--set", "time.stress_filter=auto"});
  EXPECT_EQ(element("with", words).code, 0);
}

} // namespace
} // namespace riedel::test
