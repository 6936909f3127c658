/// Plug-ins that work correctly.
#include "apps/verify/problem.hpp"
#include "core/io/table.hpp"
#include "plugin/plugins.hpp"
#include "support/law.hpp"
#include "transfers/contract.hpp"

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>
#include <random>

namespace riedel::test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

/// Random strains from random compressive states, step after step.
void integrate_at_random(LawBench& bench) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> unit(-1.0, 1.0);
  for (Index p = 0; p < bench.stress.size(); ++p) {
    Sym<double> sigma = -1e5 * Sym<double>::identity(), D = Sym<double>::zero();
    for (double& s : sigma.m) s += 2e4 * unit(random);
    for (double& rate : D.m) rate = 1e-3 * unit(random);
    bench.put(p, sigma, 0.65 + 0.1 * unit(random), D);
  }
  for (int i = 0; i < 5; ++i) bench.integrate(0.1);
}

void expect_same_bits(const Columns& a, const Columns& b) {
  ASSERT_EQ(a.components(), b.components());
  for (int c = 0; c < a.components(); ++c)
    for (Index p = 0; p < a.size(); ++p) ASSERT_EQ(a[c][p], b[c][p]) << "component " << c << ", point " << p;
}

TEST(Plugin, CopyOfTheBuiltInLawGivesTheSameBits) {
  LawBench built_in(material("gudehus_bauer"), 203);
  LawBench copied(law_of(catalogue_with(library("copied_law")), "copied_law"), 203);
  integrate_at_random(built_in);
  integrate_at_random(copied);
  expect_same_bits(built_in.stress, copied.stress);
  expect_same_bits(built_in.state, copied.state);
  EXPECT_EQ(built_in.report.evaluated_twice, copied.report.evaluated_twice);
}

TEST(Plugin, HookesLawIsTheBuiltInLinearElasticOne) {
  LawBench built_in(material("linear_elastic"), 11), plugin(law_of(catalogue_with(example("hooke")), "hooke"), 11);
  integrate_at_random(built_in);
  integrate_at_random(plugin);
  expect_same_bits(built_in.stress, plugin.stress);
}

TEST(Plugin, TellsWhatItBrings) {
  Catalogue all = full_catalogue();
  const LoadedPlugin loaded = load_plugin(library("bad_laws"), all);
  EXPECT_THAT(loaded.brings, ElementsAre("material throws", "material crashes", "material not_a_number",
                                         "material fails", "material throws_in_a_run"));
  EXPECT_THAT(loaded.compiler, HasSubstr("."));
}

TEST(Plugin, OutlivesTheCatalogueThatItWasLoadedInto) {
  const std::shared_ptr<const Material> law = [] {
    Catalogue all = full_catalogue();
    load_plugin(example("hooke"), all);
    return law_of(all, "hooke");
  }();
  EXPECT_GT(law->density({}), 0.0);
}

/// Triaxial compression has the specified initial stiffness, angle of failure and dilatancy.
TEST(WuBauer, MeetsItsStiffnessItsFrictionAndItsDilatancy) {
  const double K = (1 + std::sin(40.8 * std::numbers::pi / 180)) / (1 - std::sin(40.8 * std::numbers::pi / 180));
  const double widening =
      (1 + std::sin(13.2 * std::numbers::pi / 180)) / (1 - std::sin(13.2 * std::numbers::pi / 180)) / 2;
  LawBench bench(law_of(catalogue_with(example("wu_bauer")), "wu_bauer", {{"tolerance", 1e-9}}), 2);
  bench.put(0, -1e5 * Sym<double>::identity(), 0.7, Sym<double>{{-1.0, 0.0, 0.0, 0.0, 0.0, 0.0}});
  bench.put(1, -1e5 * Sym<double>{{K, 1.0, 1.0, 0.0, 0.0, 0.0}}, 0.7,
            Sym<double>{{-1.0, widening, widening, 0.0, 0.0, 0.0}});
  const double strain = 1e-7;
  bench.integrate(strain);
  EXPECT_NEAR((bench.stress_of(0).m[0] + 1e5) / strain, -320.0 * 1e5, 1e-4 * 320.0 * 1e5);
  EXPECT_NEAR((bench.stress_of(0).m[1] + 1e5) / strain, 0.0, 1e-4 * 320.0 * 1e5);
  for (std::size_t c = 0; c < 3; ++c) EXPECT_NEAR(bench.stress_of(1).m[c] / -1e5, c == 0 ? K : 1.0, 1e-10);
}

TEST(WuBauer, RefusesValuesThatFlowBeforeTheFrictionAngle) {
  EXPECT_THROW(law_of(catalogue_with(example("wu_bauer")), "wu_bauer", {{"poissons_ratio", 0.3}}), InputError);
}

TEST(WuBauer, FailsAtItsFrictionAngleInTheElementTest) {
  const TemporaryFolder folder;
  const Outcome outcome =
      run(folder, {"element", "triaxial", "--set", "material.plugin=" + example("wu_bauer"), "--set",
                   "material.model=wu_bauer", "--set", "output.plots=false", "--out", (folder / "out").string()});
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_NEAR(read_table(folder / "out" / "element.csv")["phi_mob_deg"].back(), 40.8, 0.01);
}

TEST(BoxedPlugin, EqualsGimpForABoxAsWideAsThePoints) {
  const Catalogue all = catalogue_with(example("boxed"));
  const TemporaryFolder folder;
  const auto history = [&](const std::string& name, const Words& more) {
    Words words = coarse_case(folder / name, {"--set", "interpolation.plugin=" + example("boxed")});
    words.insert(words.end(), {"--set", "grid.cells=[4,14]", "--set", "specimen.points_per_cell=2"});
    words.insert(words.end(), more.begin(), more.end());
    const Outcome outcome = run(folder, words);
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    return read_table(folder / name / "history.csv")["phi_mob_deg"];
  };
  const auto gimp = history("gimp", {}), boxed = history("boxed", {"--set", "scheme=boxed"});
  ASSERT_EQ(gimp.size(), boxed.size());
  for (std::size_t i = 0; i < gimp.size(); ++i) EXPECT_NEAR(gimp[i], boxed[i], 1e-6);
  EXPECT_NE(history("narrow", {"--set", "scheme=boxed", "--set", "interpolation.width=0.2"}).back(), gimp.back());
}

/// Problems with known solutions take the expected values from the scheme itself.
TEST(BoxedPlugin, BringsWhatIsToBeExpectedOfIt) {
  const Catalogue all = catalogue_with(example("boxed"));
  const auto& entry = all.in_2d.schemes.find("boxed");
  const SchemeTraits traits = entry.make(Values(entry.description.parameters))->traits();
  std::map<std::string, std::string> expected;
  for (const VerifyProblem& problem : verify_problems()) expected[problem.name] = problem.expected(traits).text;
  EXPECT_EQ(expected["square_crossing"], "1 to 2");
  EXPECT_EQ(expected["discs"], "below 0.01");
  EXPECT_EQ(expected["traction_bar"], "none");
}

template <int Dim>
TransferPointer<Dim> asflip_of(const Catalogue& all, double share, double apart) {
  const auto& entry = all.in<Dim>().transfers.find("asflip");
  Values values(entry.description.parameters);
  values.set("asflip", share);
  values.set("asflip_apart", apart);
  return entry.make(values);
}

TEST(AsflipPlugin, KeepsTheContractOfATransfer) {
  const Catalogue all = catalogue_with(example("asflip"));
  const TransferPointer<2> in_plane = asflip_of<2>(all, 0.97, 1.0);
  const TransferPointer<3> in_space = asflip_of<3>(all, 0.97, 1.0);
  expect_momenta_to_stay<2>(in_plane, "gimp");
  expect_momenta_to_stay<3>(in_space, "cpdi");
  expect_a_translation_to_stay<2>(in_plane, "gimp");
  expect_a_translation_to_stay<3>(in_space, "cpdi");
  expect_no_energy_to_be_gained<2>(in_plane, "gimp");
  expect_the_same_bits_on_any_threads<2>(in_plane, "gimp");
  expect_point_data_to_be_sorted<2>(in_plane, "gimp");
}

/// Velocities and positions after some steps of a block that is shaken.
std::vector<double> shaken_with(const TransferPointer<2>& chosen) {
  State<2> state = scattered_block<2>({4, 3}, 1e5);
  shake(state.bodies[0].points);
  Model<2> model = model_of<2>("gimp", chosen, musl_step<2>);
  model.fixed_time_step = 0.02 * cell;
  Simulation<2> simulation(std::move(model), std::move(state));
  for (int i = 0; i < 10; ++i) simulation.step();
  const Points<2>& points = simulation.state().bodies[0].points;
  std::vector<double> all;
  for (Index id = 0; id < points.size(); ++id)
    for (int a = 0; a < 2; ++a) {
      const Index p = points.place[static_cast<std::size_t>(id)];
      all.insert(all.end(), {points.velocity[a][p], points.position[a][p]});
    }
  return all;
}

TEST(AsflipPlugin, IsApicWithoutFlipAndMovesPointsThatHaveGrown) {
  const Catalogue all = catalogue_with(example("asflip"));
  const std::vector<double> apic = shaken_with(transfer<2>("apic")), pure = shaken_with(asflip_of<2>(all, 0.0, 1.0)),
                            together = shaken_with(asflip_of<2>(all, 0.97, 0.0)),
                            apart = shaken_with(asflip_of<2>(all, 0.97, 1.0));
  for (std::size_t i = 0; i < apic.size(); ++i) EXPECT_NEAR(pure[i], apic[i], 1e-10);
  EXPECT_NE(together, apic);
  EXPECT_NE(apart, together);
}

TEST(AsflipPlugin, RunsInTheProgramByItsKeys) {
  const TemporaryFolder folder;
  const auto history = [&](const std::string& name, const Words& more) {
    Words words = coarse_case(folder / name, {"--set", "time.plugin=" + example("asflip"), "--set", "nonlocal.length=0",
                                              "--set", "output.vtk=false", "--set", "output.plots=false"});
    words.insert(words.end(), more.begin(), more.end());
    const Outcome outcome = run(folder, words);
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    return read_table(folder / name / "history.csv")["phi_mob_deg"];
  };
  const auto usual = history("usual", {"--set", "time.transfer=asflip"});
  EXPECT_NE(history("less", {"--set", "time.transfer=asflip", "--set", "time.asflip=0.5"}), usual);
  EXPECT_NE(history("flip", {}), usual);
  const Outcome listed = run(folder, {"list", "asflip", "--plugin", example("asflip")});
  EXPECT_THAT(listed.out, HasSubstr("Fei, Guo, Wu, Huang & Gao (2021)"));
  EXPECT_THAT(listed.out, HasSubstr("asflip_apart"));
}

TEST(PluginInTheProgram, ShowsItsParametersInListAndCheck) {
  const TemporaryFolder folder;
  const Outcome listed = run(folder, {"list", "--plugin", example("wu_bauer")});
  EXPECT_EQ(listed.code, 0) << listed.err;
  EXPECT_THAT(listed.out, HasSubstr("wu_bauer: hypoplasticity of four constants"));
  EXPECT_THAT(listed.out, HasSubstr("friction angle of steady flow"));
  EXPECT_THAT(listed.out, HasSubstr("material wu_bauer"));
  const Words with{"check", "--set", "material.plugin=" + example("wu_bauer"), "--set", "material.model=wu_bauer"};
  EXPECT_THAT(run(folder, with).out, HasSubstr("phi = 40.8"));
  Words wrong = with;
  wrong.insert(wrong.end(), {"--set", "material.phi=95"});
  const Outcome refused = run(folder, wrong);
  EXPECT_EQ(refused.code, 2);
  EXPECT_THAT(refused.err, HasSubstr("material.phi"));
}

TEST(PluginInTheProgram, IsFoundInTheFoldersOfThePath) {
  const TemporaryFolder folder;
  std::filesystem::copy_file(example("hooke"), folder / "hooke.so");
  ::setenv("RIEDEL_PLUGIN_PATH", folder.path().c_str(), 1);
  const Outcome by_path = run(folder, {"list", "materials"});
  const Outcome named = run(folder, {"list", "plugins", "--plugin", "hooke.so"}); // once, not twice
  ::setenv("RIEDEL_PLUGIN_PATH", "/no/such/folder", 1);
  const Outcome missing = run(folder, {"list"});
  ::unsetenv("RIEDEL_PLUGIN_PATH");
  EXPECT_THAT(by_path.out, HasSubstr("hooke: Hooke's law in rates, as a plug-in"));
  EXPECT_EQ(named.code, 0) << named.err;
  EXPECT_EQ(missing.code, 4);
  EXPECT_THAT(missing.err, HasSubstr("RIEDEL_PLUGIN_PATH: /no/such/folder"));
}

/// Searched pair by pair, averaged without weights: other numbers, from the plug-in's own classes.
TEST(PluginInTheProgram, SearchesAndAveragesInItsOwnWay) {
  const TemporaryFolder folder;
  const auto angles = [&](const std::string& name, const Words& more) {
    Words words = coarse_case(folder / name, {"--set", "nonlocal.plugin=" + library("neighbours"), "--set",
                                              "output.vtk=false", "--set", "output.plots=false"});
    words.insert(words.end(), more.begin(), more.end());
    const Outcome outcome = run(folder, words);
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    return read_table(folder / name / "history.csv")["phi_mob_deg"];
  };
  const auto built_in = angles("built_in", {});
  EXPECT_EQ(angles("searched", {"--set", "nonlocal.search=pair_by_pair"}), built_in);
  EXPECT_NE(angles("averaged", {"--set", "nonlocal.search=pair_by_pair", "--set", "nonlocal.averager=plain"}),
            built_in);
}

TEST(InstalledProgram, RunsAnElementTestWithAPlugin) {
  const TemporaryFolder folder;
  const std::string command = INSTALLED "/bin/riedel element oedometer --set material.plugin=" + example("hooke") +
                              " --set material.model=hooke --set output.plots=false --out " +
                              (folder / "out").string() + " >" + (folder / "log").string() + " 2>&1";
  EXPECT_EQ(std::system(command.c_str()), 0) << file_content(folder / "log");
}

} // namespace
} // namespace riedel::test
