/// UMATs: Riedel's own in Fortran against the built-in laws, and faulty ones in C.
#include "materials/umat.hpp"
#include "plugin/umats.hpp"
#include "support/one_point.hpp"

namespace riedel::test {
namespace {

using testing::AllOf;
using testing::HasSubstr;

std::shared_ptr<const Material> umat(const std::string& path, std::map<std::string, Value> with = {}) {
  with["library"] = path;
  return material("umat", with);
}

/// Where there is no Fortran compiler, there are no UMATs in Fortran.
class FortranUmat : public testing::Test {
protected:
  void SetUp() override {
    if (!std::filesystem::exists(example("elastic_umat"))) GTEST_SKIP() << "no Fortran compiler was found";
  }
  TemporaryFolder folder_;
};

/// The law of the paper, from a separate source in Fortran.
Words sand_umat() {
  const double radians = 30.0 * std::numbers::pi / 180.0;
  return {"--set", "material.model=umat",
          "--set", "material.library=" + example("gudehus_bauer_umat"),
          "--set", "material.parameters=[" + exact_text(radians) + ",190e6,0.5,1.3,0.51,0.82,0.3,1,2e-5,10,0]",
          "--set", "material.state=[0.55]",
          "--set", "material.state_names=void_ratio"};
}

/// The same with the average of ‖D‖ in DPRED(1).
Words nonlocal_sand_umat() {
  Words words = sand_umat();
  words.insert(words.end(), {"--set", "material.takes_average=true", "--set",
                             "material.parameters=[" + exact_text(30.0 * std::numbers::pi / 180.0) +
                                 ",190e6,0.5,1.3,0.51,0.82,0.3,1,2e-5,10,1]"});
  return words;
}

TEST_F(FortranUmat, OfHookesLawIsTheBuiltInOne) {
  const auto law = umat(example("elastic_umat"), {{"parameters", std::vector<double>{1e7, 0.3}}});
  const auto built_in = material("linear_elastic", {{"youngs_modulus", 1e7}, {"poissons_ratio", 0.3}});
  const Sym<double> strain{{1e-3, -2e-3, 5e-4, 3e-4, -7e-4, 2e-4}};
  const Sym<double> ours = strained(law, strain), theirs = strained(built_in, strain);
  EXPECT_LT(norm(ours - theirs), 1e-14 * norm(theirs));
}

TEST_F(FortranUmat, GivesTheWaveSpeedFromItsStiffness) {
  LawBench bench = one_point(umat(example("elastic_umat"), {{"parameters", std::vector<double>{1e7, 0.3}}}));
  bench.integrate(0.0);
  const double longitudinal = 1e7 * 0.7 / (1.3 * 0.4);
  EXPECT_NEAR(bench.law->assess(bench.batch).wave_speed, std::sqrt(longitudinal / 2000.0), 1e-9);
}

/// Along the strains of a plane strain compression to 6 %, past the peak, as the point driver found them.
TEST_F(FortranUmat, OfThePapersLawFollowsTheBuiltInOneAlongPlaneStrain) {
  const Outcome outcome = run(folder_, {"element", "biaxial", "--set", "output.plots=false", "--set",
                                        "output.every_strain=5e-5", "--out", (folder_ / "out").string()});
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  const auto path = read_table(folder_ / "out" / "element.csv");
  const double radians = 30.0 * std::numbers::pi / 180.0;
  const std::vector<double> constants{radians, 190e6, 0.5, 1.3, 0.51, 0.82, 0.3, 1.0, 1e-5, 10.0, 0.0};
  LawBench fortran(
      umat(example("gudehus_bauer_umat"), {{"parameters", constants}, {"state_names", std::string("void_ratio")}}), 1);
  LawBench built_in(material("gudehus_bauer", {{"tolerance", 1e-11}}), 1);
  for (LawBench* bench : {&fortran, &built_in})
    bench->put(0, -50e3 * Sym<double>::identity(), 0.55, Sym<double>::zero());
  for (std::size_t row = 1; row < path["eps_1"].size(); ++row) {
    Sym<double> strain = Sym<double>::zero();
    for (const auto& [axis, name] : {std::pair{1, "eps_1"}, {0, "eps_2"}, {2, "eps_3"}}) // compression positive
      strain.m[static_cast<std::size_t>(axis)] = std::log((1.0 - path[name][row]) / (1.0 - path[name][row - 1]));
    for (LawBench* bench : {&fortran, &built_in}) {
      bench->put_rate(0, strain);
      for (int i = 0; i < 10; ++i) bench->integrate(0.1);
    }
    const Sym<double> wanted = built_in.stress_of(0);
    ASSERT_LT(norm(fortran.stress_of(0) - wanted), 1e-8 * norm(wanted)) << "at " << path["eps_1"][row];
  }
  EXPECT_GT(-built_in.stress_of(0).m[1], 200e3) << "has been compressed";
}

TEST_F(FortranUmat, OfThePapersLawPeaksAsTheBuiltInOneInTheBiaxialTestOnOneThreadAndOnTwo) {
  const auto history = [&](const std::string& name, const Words& law, const std::string& threads) {
    Words words =
        coarse_case(folder_ / name, joined(law, {"--set", "loading.final_strain=0.018", "--set", "time.step=4e-6",
                                                 "--set", "output.plots=false", "--set", "output.vtk=false", "--set",
                                                 "time.damping=1e4", "--set", "time.stress_filter=1e4"}));
    *std::next(std::ranges::find(words, "--threads")) = threads;
    const Outcome outcome = run(folder_, words);
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    return read_table(folder_ / name / "history.csv")["phi_mob_deg"];
  };
  const auto built_in = history("built_in", {"--set", "material.tolerance=1e-8"}, "2"),
             one = history("one", nonlocal_sand_umat(), "1");
  EXPECT_NEAR(std::ranges::max(one), std::ranges::max(built_in), 0.05);
  EXPECT_EQ(one, history("two", nonlocal_sand_umat(), "2"));
}

TEST_F(FortranUmat, IsReportedOnByTheCheck) {
  const Outcome outcome =
      run(folder_, {"umat-check", example("elastic_umat"), "--set", "material.parameters=[1e7,0.3]"});
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_THAT(outcome.out, AllOf(HasSubstr("turned by six rotations: the stress"), HasSubstr("good"),
                                 HasSubstr("the tangent of the step"), HasSubstr("the path does not matter")));
}

TEST(Umat, IsCalledAgainWithShorterStepsWhenItAsksForThem) {
  LawBench bench = one_point(umat(library("umat_0")));
  const Sym<double> strain{{1e-4, 0.0, 0.0, 0.0, 0.0, 0.0}};
  EXPECT_NEAR(strained(bench, strain).m[0], 1e7 * 1e-4, 1e-9);
  EXPECT_EQ(bench.report.substepped, 1);
  EXPECT_GE(bench.report.substeps, 10);
}

TEST(Umat, ThatCallsXitIsNeverContentOrReturnsNanFailsAtThePoint) {
  for (const auto& [number, reason] :
       {std::pair{"umat_1", "called XIT"}, {"umat_2", "asking for shorter steps"}, {"umat_3", "not finite"}}) {
    LawBench bench = one_point(umat(library(number)));
    bench.put(0, Sym<double>::identity(), 0.0, Sym<double>{{1e-4, 0.0, 0.0, 0.0, 0.0, 0.0}});
    bench.integrate(1.0);
    EXPECT_EQ(bench.report.failures, 1) << number;
    EXPECT_THAT(std::string(bench.report.reason), HasSubstr(reason));
    EXPECT_EQ(bench.stress_of(0).m[0], 1.0) << "the state is left as it was";
  }
}

TEST(Umat, ThatCallsXitEndsTheRunAndLeavesItsSummary) {
  const TemporaryFolder folder;
  const Outcome outcome =
      run(folder, coarse_case(folder / "out", {"--set", "material.model=umat", "--set",
                                               "material.library=" + library("umat_1"), "--set", "nonlocal.length=0"}));
  EXPECT_EQ(outcome.code, 3);
  EXPECT_THAT(outcome.err, AllOf(HasSubstr("the UMAT called XIT; stress (-"), HasSubstr("umat_strain"),
                                 HasSubstr("first at point"), HasSubstr("step ")));
  EXPECT_THAT(file_content(folder / "out" / "summary.json"), HasSubstr("\"failed\""));
}

TEST(Umat, TurnsItsTensorStatesAndKeepsTheirEngineeringShear) {
  const auto law = umat(library("umat_0"), {{"state", std::vector<double>{1.0, 0.0, 0.0, 2.0, 0.0, 0.0, 7.0}},
                                            {"state_names", std::string("h:strain, flag")}});
  ASSERT_EQ(law->states()[0].components, 6);
  EXPECT_EQ(law->states()[1].name, "flag");
  LawBench bench = one_point(law);
  const std::vector<double> start = law->initial_state();
  for (std::size_t s = 0; s < start.size(); ++s) bench.state[static_cast<int>(s)][0] = start[s];
  EXPECT_NEAR(bench.tensor_of("h", 0).m[3], std::numbers::sqrt2, 1e-15) << "a tensor component of 1";
  EXPECT_EQ(bench.state[6][0], 7.0);
}

/// A UMAT that sums up the strain and does not rotate the sum.
TEST(Umat, PassesTheCheckIfItsTensorStateIsDeclaredAndFailsItOtherwise) {
  const TemporaryFolder folder;
  const Words words{"umat-check", library("umat_4"), "--set", "material.state=[1e-3,2e-3,-1e-3,1e-3,0,5e-4]"};
  EXPECT_EQ(run(folder, joined(words, {"--set", "material.state_names=h:strain"})).code, 0);
  const Outcome outcome = run(folder, words);
  EXPECT_EQ(outcome.code, 3);
  EXPECT_THAT(outcome.out, HasSubstr("BAD: the answer depends on the frame"));
}

TEST(Umat, IsCheckedWithTheCaseOfARun) {
  const TemporaryFolder folder;
  const std::string law = "[material]\nmodel = \"umat\"\nparameters = [2e7, 0.25]\n";
  const Words words{"umat-check", example("elastic_umat"), (folder / "case.toml").string()};
  (void)folder.file("case.toml", "scheme = \"cpdi\"\n[grid]\ncells = [4, 8]\n[nonlocal]\nlength = 0\n" + law);
  EXPECT_EQ(run(folder, words).code, 0) << run(folder, words).err;
  (void)folder.file("case.toml", "test = \"triaxial\"\n[loading]\nfinal_strain = 0.01\n" + law);
  EXPECT_EQ(run(folder, words).code, 0) << run(folder, words).err;
  (void)folder.file("case.toml", "[gird]\ncells = [4, 8]\n" + law);
  const Outcome outcome = run(folder, words);
  EXPECT_EQ(outcome.code, 2);
  EXPECT_THAT(outcome.err, HasSubstr("case.toml:2:9: gird.cells"));
}

TEST(Umat, RefusesStatesThatDoNotFitTheirNames) {
  const std::vector<double> two{1.0, 2.0};
  EXPECT_THROW(umat(library("umat_0"), {{"state", two}, {"state_names", std::string("h:strain")}}), InputError);
  EXPECT_THROW(umat(library("umat_0"), {{"state_names", std::string("h:tensor")}}), InputError);
  EXPECT_THROW(umat("/no/such/umat.so"), PluginError);
  EXPECT_THROW(umat(library("bad_0")), PluginError) << "has no umat_";
}

TEST(Umat, WhoseLibraryIsMissingLeavesEarlierResultsAsTheyAre) {
  const TemporaryFolder folder;
  std::filesystem::create_directory(folder / "out");
  folder.file("out/history.csv", "old");
  for (const auto& [library, code, reason] :
       {std::tuple{"/no/such/umat.so", 4, "UMAT /no/such/umat.so: there is no such file"},
        {"", 2, "material.library (default): names no library"}}) {
    Words words =
        coarse_case(folder / "out", {"--set", "material.model=umat", "--set", "nonlocal.length=0", "--force"});
    if (*library) words.insert(words.end(), {"--set", std::string("material.library=") + library});
    const Outcome outcome = run(folder, words);
    EXPECT_EQ(outcome.code, code);
    EXPECT_THAT(outcome.err, HasSubstr(reason));
    EXPECT_EQ(file_content(folder / "out" / "history.csv"), "old");
  }
}

TEST(Umat, WithoutALibraryFailsInItsFirstStepWithTheKeysName) {
  LawBench bench = one_point(material("umat"));
  bench.integrate(1.0);
  EXPECT_THAT(std::string(bench.report.reason), HasSubstr("material.library"));
}

/// A library with global data, called from two threads at once: each has a copy.
TEST(Umat, HasACopyOfItsLibraryForEachThread) {
  UmatLibrary shared(library("umat_0"), "umat_", true), copied(library("umat_0"), "umat_", false);
  const auto first = copied.lease(), second = copied.lease();
  EXPECT_NE(first.function(), second.function());
  const auto a = shared.lease(), b = shared.lease();
  EXPECT_EQ(a.function(), b.function());
}

} // namespace
} // namespace riedel::test
