/// A case reports what its law can use: no length without an average, no patch of void ratios for a law without one,
/// and no key without effect.
#include "apps/biaxial/law_uses.hpp"
#include "apps/program.hpp"
#include "core/case/case_text.hpp"
#include "core/setup/weak_zone.hpp"
#include "verification/biaxial.hpp"

#include <gmock/gmock.h>

namespace riedel::test {
namespace {

using testing::AllOf;
using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;
using testing::StartsWith;

CheckedCase checked(const std::vector<std::string>& settings) {
  CaseFile file = CaseFile::empty();
  for (const std::string& setting : settings) file.override_with(setting);
  return biaxial_case(file, catalogue());
}
std::string refusal(const std::vector<std::string>& settings) {
  try {
    (void)checked(settings);
  } catch (const InputError& error) { return error.what(); }
  return "no error";
}

template <class Property>
std::vector<std::string> laws_whose(const Property& property) {
  std::vector<std::string> names = law_names();
  std::erase_if(names, [&](const std::string& name) { return !property(*material(name)); });
  return names;
}
const std::vector<std::string> without_average =
    laws_whose([](const Material& law) { return law.nonlocal_variables().empty(); });
bool knows_void_ratio(const Material& law) { return state_column(law.states(), "void_ratio") >= 0; }
bool has_strength(const std::string& law) {
  return law_has(law, "cohesion") || law_has(law, "friction_angle") || law_has(law, "phi_c");
}

TEST(LawUses, ALawThatTakesNothingAveragedRunsLocallyAndTheCaseSaysSo) {
  for (const std::string& law : without_average) {
    const CheckedCase c = checked({"material.model=" + law});
    EXPECT_EQ(c.values.number("nonlocal.length"), 0.0) << law;
    EXPECT_THAT(c.notes,
                Contains(AllOf(StartsWith("nonlocal.length = 0: "), HasSubstr(law), HasSubstr("run is local"))));
    EXPECT_THAT(case_text(c.keys, c.values),
                testing::ContainsRegex("\nlength = 0[.]0 .*here 0, since \"" + law + "\" uses no average"));
    EXPECT_THAT(refusal({"material.model=" + law, "nonlocal.length=1.5e-3"}),
                AllOf(StartsWith("--set nonlocal.length: 0.0015 is out of range: \"" + law + "\" uses no average"),
                      HasSubstr("allowed: 0")));
    EXPECT_EQ(refusal({"material.model=" + law, "nonlocal.length=0"}), "no error");
  }
}

TEST(LawUses, TheCaseOfSuchARunIsACaseAgain) {
  const TemporaryFolder folder;
  for (const std::string& law : without_average) {
    const CheckedCase c = checked({"material.model=" + law});
    const CaseFile file = CaseFile::read(folder.file("case.toml", case_text(c.keys, c.values)));
    const CheckedCase again = biaxial_case(file, catalogue());
    EXPECT_EQ(again.values.all(), c.values.all()) << law;
    EXPECT_THAT(again.notes, IsEmpty()) << "they stand in the case now";
    EXPECT_THAT(again.warnings, IsEmpty());
  }
}

TEST(LawUses, WithIntergranularStrainTheDefaultIsLocal) {
  const CheckedCase c = checked({"material.intergranular_strain=true"});
  EXPECT_EQ(c.values.number("nonlocal.length"), 0.0);
  EXPECT_THAT(c.notes, ElementsAre(HasSubstr("intergranular strain")));
}

TEST(LawUses, ALawThatSoftensAveragesItsPlasticStrain) {
  for (const std::string& law : laws_with("cohesion_residual")) {
    const CheckedCase c = checked({"material.model=" + law, "material.cohesion_residual=1e3"});
    EXPECT_EQ(c.values.number("nonlocal.length"), 1.5e-3);
    EXPECT_EQ(c.values.text("nonlocal.variable"), "plastic_strain");
  }
}

TEST(LawUses, KeysOfVoidRatiosMeanNothingToALawWithoutOne) {
  std::string others;
  for (const std::string& law : laws_whose(knows_void_ratio)) others += (others.empty() ? "" : ", ") + law;
  for (const std::string& law : laws_whose([](const Material& each) { return !knows_void_ratio(each); })) {
    for (const std::string setting :
         {"specimen.void_ratio=0.6", "imperfection.void_ratio=0.8", "imperfection.deviation=0.01",
          "imperfection.correlation_length=2e-3", "imperfection.seed=2", "output.band_void_ratio=0.8"}) {
      const std::string key = setting.substr(0, setting.find('='));
      EXPECT_THAT(refusal({"material.model=" + law, setting}),
                  AllOf(StartsWith("--set " + key + ": "), HasSubstr("\"" + law + "\" has no void ratio"),
                        HasSubstr("take one of the laws that have it: " + others)));
      EXPECT_THAT(case_text(checked({"material.model=" + law}).keys, checked({"material.model=" + law}).values),
                  Not(HasSubstr("void_ratio =")));
    }
    EXPECT_THAT(checked({"material.model=" + law}).values.numbers("imperfection.size"), ElementsAre(0.0, 0.0));
    EXPECT_THAT(
        refusal({"material.model=" + law, "imperfection.size=[5e-3,5e-3]"}),
        AllOf(StartsWith("--set imperfection.size: [0.005, 0.005] means nothing to"), HasSubstr("allowed: [0, 0]")));
  }
}

/// For a UMAT its keys state what it uses.
TEST(LawUses, OfAUmatAreWhatItsKeysSay) {
  const auto uses = [](std::initializer_list<std::pair<const char*, Value>> settings) {
    Values values(biaxial_keys(catalogue(), "umat"));
    values.set("material.model", std::string("umat"));
    for (const auto& [key, value] : settings) values.set(key, value);
    return law_uses(values, catalogue()).value();
  };
  EXPECT_FALSE(uses({}).void_ratio);
  EXPECT_FALSE(uses({}).strength);
  EXPECT_THAT(uses({}).averaged, IsEmpty());
  EXPECT_THAT(uses({}).why_local, HasSubstr("without material.takes_average = true"));
  EXPECT_TRUE(uses({{"material.state_names", std::string("h:strain, void_ratio")}}).void_ratio);
  EXPECT_THAT(uses({{"material.takes_average", true}}).averaged, ElementsAre("rate_norm"));
}

TEST(LawUses, AFactorOfStrengthNeedsALawWithStrength) {
  for (const std::string& law : law_names()) {
    const std::vector<std::string> weaker{"material.model=" + law, "imperfection.factor=0.8"};
    if (has_strength(law)) {
      EXPECT_THAT(checked(weaker).values.numbers("imperfection.size"), ElementsAre(5e-3, 5e-3));
    } else {
      EXPECT_THAT(refusal(weaker), AllOf(StartsWith("--set imperfection.factor: 0.8 means nothing to \"" + law + "\""),
                                         HasSubstr("allowed: 1")));
    }
  }
  EXPECT_EQ(refusal({"material.model=linear_elastic", "imperfection.factor=1"}), "no error");
  EXPECT_THAT(refusal({"imperfection.factor=0"}), HasSubstr("allowed: a number > 0"));
}

TEST(LawUses, KeysThatNothingLooksAtAreTold) {
  const auto warning = [](const std::vector<std::string>& settings) {
    const CheckedCase c = checked(settings);
    return c.warnings.empty() ? std::string() : c.warnings.front();
  };
  for (const std::vector<std::string>& settings :
       std::vector<std::vector<std::string>>{{"nonlocal.search=cell_list", "nonlocal.length=0"},
                                             {"nonlocal.averager=gauss_grid", "nonlocal.length=0"},
                                             {"imperfection.centre=[0.5,0.5]", "imperfection.size=[0,0]"},
                                             {"imperfection.void_ratio=0.8", "imperfection.size=[0,0]"},
                                             {"imperfection.factor=0.8", "imperfection.size=[0,0]"},
                                             {"imperfection.seed=7"},
                                             {"imperfection.correlation_length=2e-3"},
                                             {"output.frames_every_strain=0.01", "output.vtk=false"},
                                             {"time.cfl=0.3", "time.step=1e-6"},
                                             {"material.R=2e-4"},
                                             {"material.softening_strain=0.2", "material.model=mohr_coulomb"}}) {
    const std::string key = settings.front().substr(0, settings.front().find('='));
    EXPECT_THAT(warning(settings), AllOf(StartsWith("--set " + key + ": "), HasSubstr(" has no effect: "))) << key;
  }
  EXPECT_EQ(warning({"imperfection.seed=7", "imperfection.deviation=0.01"}), "");
  EXPECT_EQ(warning({"nonlocal.search=cell_list"}), "");
}

TEST(LawUses, ThePicturesTitleAndTheChecksAnswerAreLocalToo) {
  const TemporaryFolder folder;
  const Outcome check = run(folder, {"check", "--set", "material.model=linear_elastic"});
  EXPECT_EQ(check.code, 0);
  EXPECT_THAT(check.err, HasSubstr("riedel: note: nonlocal.length = 0: \"linear_elastic\" uses no average"));
  EXPECT_THAT(check.out, HasSubstr("\nlength = 0.0 "));
  const Outcome outcome =
      run(folder, {"biaxial", "--set", "material.model=linear_elastic", "--set", "grid.cells=[4,8]", "--set",
                   "loading.final_strain=0.001", "--set", "loading.speed=0.5", "--out", (folder / "out").string()});
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_THAT(outcome.err, HasSubstr("riedel: note: nonlocal.length = 0: "));
  EXPECT_THAT(file_content(folder / "out" / "history.svg"), Not(HasSubstr("l_c")));
}

/// A Mohr-Coulomb specimen with a weak patch yields there first, and is a single body with all its points.
TEST(WeakZone, LowersTheStrengthInThePatchAlone) {
  const auto plastic_strain = [](const std::string& factor) {
    const BiaxialCase v = biaxial_values({"material.model=mohr_coulomb", "grid.cells=[8,28]", "loading.speed=0.5",
                                          "loading.gravity=0", "imperfection.factor=" + factor});
    Simulation<2> simulation = make_biaxial(v, catalogue());
    const Body<2>& body = simulation.state().bodies.front();
    EXPECT_EQ(simulation.state().bodies.size(), 1U);
    EXPECT_EQ(body.points.size(), 8 * 28);
    const int kappa = state_column(body.material->states(), "plastic_strain"),
              zone = state_column(body.material->states(), WeakZoneLaw::zone);
    double inside = 0.0, outside = 0.0;
    while (simulation.state().time < 8e-3 && inside + outside == 0.0) {
      simulation.step();
      for (Index p = 0; p < body.points.size(); ++p)
        (zone >= 0 && body.points.state[zone][p] > 0.5 ? inside : outside) += body.points.state[kappa][p];
    }
    return std::pair(inside, outside);
  };
  const auto [weak, sound] = plastic_strain("0.5");
  EXPECT_GT(weak, 0.0);
  EXPECT_EQ(sound, 0.0);
}

/// Points of both kinds, mixed: each behaves exactly as under its own law alone.
TEST(WeakZone, GivesEveryPointItsOwnLaw) {
  const Keys keys = catalogue().materials.find("mohr_coulomb").description.parameters;
  const Values sound(keys), weak = weakened(sound, 0.5);
  EXPECT_EQ(weak.number("cohesion"), 2.5e3);
  EXPECT_NEAR(std::tan(weak.number("friction_angle") * std::numbers::pi / 180), 0.5 * std::tan(std::numbers::pi / 6),
              1e-12);
  const auto make = [](const Values& v) { return catalogue().materials.find("mohr_coulomb").make(v); };
  const WeakZoneLaw both(make(sound), make(weak));
  constexpr Index count = 21;
  const auto state_of = [&](Index p) { return p % 5 < 2 ? 1.0 : 0.0; };
  const auto sheared = [&](const Material& law, bool with_zone, Index from, Index points) {
    Columns stress(6), state(state_components(law.states())), rate(6);
    for (Columns* columns : {&stress, &state, &rate}) columns->resize(points);
    for (Index p = 0; p < points; ++p) {
      for (int c = 0; c < 3; ++c) stress[c][p] = -20e3 - 100.0 * (from + p);
      rate[0][p] = 1.0;
      rate[1][p] = -1.0;
      if (with_zone) state[state.components() - 1][p] = state_of(from + p);
    }
    MaterialBatch batch;
    batch.size = points;
    batch.time_step = 5e-3;
    std::vector<double*> columns;
    for (int c = 0; c < 6; ++c)
      batch.stress[static_cast<std::size_t>(c)] = stress[c], batch.rate[static_cast<std::size_t>(c)] = rate[c];
    for (int s = 0; s < state.components(); ++s) columns.push_back(state[s]);
    batch.state = columns;
    MaterialReport report;
    law.integrate(batch, report);
    EXPECT_EQ(report.failures, 0);
    std::vector<std::array<double, 6>> answer;
    for (Index p = 0; p < points; ++p) {
      std::array<double, 6> sigma{};
      for (int c = 0; c < 6; ++c) sigma[static_cast<std::size_t>(c)] = stress[c][p];
      answer.push_back(sigma);
    }
    return answer;
  };
  const auto mixed = sheared(both, true, 0, count);
  const auto alone_sound = make(sound), alone_weak = make(weak);
  for (Index p = 0; p < count; ++p)
    EXPECT_EQ(mixed[static_cast<std::size_t>(p)],
              sheared(state_of(p) > 0.5 ? *alone_weak : *alone_sound, false, p, 1).front())
        << p;
}

} // namespace
} // namespace riedel::test
