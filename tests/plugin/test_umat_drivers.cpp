/// Every driver passes the same motion and time to a UMAT: an auditing one is run by all of them, and laws that depend
/// on DFGRD1 or on TIME alone are compared with closed forms.
#include "plugin/umats.hpp"

namespace riedel::test {
namespace {

using testing::HasSubstr;

const std::string neo_hooke = "[8e6,1.7e7]"; ///< μ, κ [Pa]

/// σ1 of the neo-Hookean law in an oedometer at a strain of 6 %, compression positive [kPa].
double neo_hooke_in_the_oedometer() {
  const double J = 0.94, mu = 8e6, kappa = 1.7e7;
  return -1e-3 * (mu * std::pow(J, -5.0 / 3.0) * 2.0 / 3.0 * (J * J - 1.0) + kappa * (J - 1.0));
}

TEST(UmatDrivers, GiveTheOedometerOfALawOfTheDeformationGradient) {
  const TemporaryFolder folder;
  const Words law = joined(umat_named("motion_umats", "NEO_HOOKE", neo_hooke), set({"loading.initial_pressure=1"}));
  const double wanted = neo_hooke_in_the_oedometer();
  EXPECT_NEAR(wanted, 1708.2, 0.05);
  EXPECT_NEAR(last_stress(folder, element(folder, "oedometer", law)), wanted, 1e-5 * wanted);
  const Words mpm = joined(law, set({"loading.final_stress=1e9", "loading.speed=0.02"}));
  const Outcome outcome = run(folder, element(folder, "oedometer", mpm, {"--driver", "mpm"}));
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  const auto curve = read_table(folder / "out" / "element.csv");
  const double J = 1.0 - curve["eps_1"].back();
  const double there = -1e-3 * (8e6 * std::pow(J, -5.0 / 3.0) * 2.0 / 3.0 * (J * J - 1.0) + 1.7e7 * (J - 1.0));
  EXPECT_NEAR(1e-3 * curve["sigma_1_Pa"].back(), there, 2e-3 * there);
}

/// Simple shear with free height: vertical lines rotate, which the law obtains from F alone. The closed form holds for
/// the shear stress, μ γ λ / J^(5/3), and the height λ that keeps the normal stress.
TEST(UmatDrivers, GiveTheShearOfALawOfTheDeformationGradient) {
  const TemporaryFolder folder;
  const Words law = umat_named("motion_umats", "NEO_HOOKE", neo_hooke);
  const Words test = set({"loading.normal_stress=1", "loading.final_strain=0.3", "output.every_strain=0.01"});
  const Outcome outcome = run(folder, element(folder, "shear", law, test));
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  const auto curve = read_table(folder / "out" / "element.csv");
  const double gamma = curve["gamma"].back(), J = 1.0 - curve["eps_2"].back(); // the height alone changes
  EXPECT_NEAR(gamma, 0.3, 1e-9);
  EXPECT_NEAR(curve["tau_Pa"].back(), 8e6 * std::pow(J, -5.0 / 3.0) * gamma * J, 1e-4 * 8e6 * gamma);
}

/// E(1 + t): ∫ M (1 + t) dε over two seconds, ε = −ln(1 − t/100).
TEST(UmatDrivers, GiveTheOedometerOfALawThatAges) {
  const TemporaryFolder folder;
  const double M = 1e3 * 0.7 / (1.3 * 0.4);                  // [kPa]
  const double wanted = M * (101.0 * -std::log(0.98) - 2.0); // ∫ (1 + t)/(100 − t) dt
  const Words law = umat_named("motion_umats", "AGEING", "[1e6,0.3]");
  const Words test = set({"loading.initial_pressure=1", "loading.final_strain=0.02", "loading.rate=0.01"});
  EXPECT_NEAR(wanted, 54.5, 0.05);
  EXPECT_NEAR(last_stress(folder, element(folder, "oedometer", law, test)), wanted, 1e-3 * wanted);
  const Words mpm = joined(law, set({"loading.speed=0.002", "loading.ramp_time=0", "specimen.size=0.2"}));
  EXPECT_NEAR(last_stress(folder, element(folder, "oedometer", joined(mpm, test), {"--driver", "mpm"})), wanted,
              5e-3 * wanted);
}

/// Two stages of one second each, with the same strain: the second begins at TIME(1) = 0 again.
TEST(UmatDrivers, CountTheTimeOfAStageFromItsStart) {
  const TemporaryFolder folder;
  std::string text = "[initial]\nsigma = [1, 1, 1]\n";
  for (const char* strain : {"0.01", "0.02"})
    text += std::string("[[stage]]\nduration = 1\nln_1 = ") + strain + "\nln_2 = \"hold\"\nln_3 = \"hold\"\n";
  const std::filesystem::path path = folder.file("two.toml", text);
  const double M = 1e3 * 0.7 / (1.3 * 0.4);
  for (const auto& [name, times] : {std::pair{"AGEING", 2.0 * 0.01 + 0.01 * 2.0}, {"AGEING_BY_STAGE", 0.03}}) {
    const Words law = umat_named("motion_umats", name, "[1e6,0.3]");
    Words words = element(folder, "path", law);
    words.insert(words.begin() + 2, path.string());
    EXPECT_NEAR(last_stress(folder, words), M * times, 2e-3 * M * times) << name;
  }
}

/// The auditing UMAT: PROPS(3) whether rotations follow the spin, PROPS(4) the longest strain of a part of a step.
Words audit(const std::string& with_spin, const std::string& longest) {
  const std::string states = "[0,0,0,0,0,0" + [] {
    std::string zeros;
    for (int i = 0; i < 26; ++i) zeros += ",0";
    return zeros;
  }() + "]";
  return joined(umat_named("motion_umats", "AUDIT", "[1e7,0.3," + with_spin + "," + longest + "]"),
                set({"material.state=" + states, "material.state_names=\"copy:stress\""}));
}

class AuditedDriver : public testing::TestWithParam<const char*> {};

TEST_P(AuditedDriver, TellsAUmatOfStepsThatFollowEachOther) {
  const TemporaryFolder folder;
  const std::string driver = GetParam();
  for (const std::string test : {"oedometer", "triaxial", "shear", "biaxial"})
    for (const std::string longest : {"0", "3e-5"}) {
      const Words few = set({"loading.final_strain=0.004", "output.every_strain=1e-3", "loading.speed=0.1"});
      const Outcome outcome =
          run(folder, element(folder, test, joined(audit("1", longest), few), {"--driver", driver}));
      EXPECT_EQ(outcome.code, 0) << driver << ", " << test << ", parts of " << longest << ": " << outcome.err;
      EXPECT_THAT(outcome.err, testing::Not(HasSubstr("audit")));
    }
}

INSTANTIATE_TEST_SUITE_P(Kinds, AuditedDriver, testing::Values("point", "mpm"),
                         [](const auto& tested) { return std::string(tested.param); });

/// A shear to 10 %, under each order of the step and with both rotations of stress.
TEST(UmatDrivers, OfMpmTellAUmatOfRotations) {
  const TemporaryFolder folder;
  for (const auto& [rate, with_spin] : {std::pair{"jaumann", "1"}, {"green_naghdi", "0"}})
    for (const std::string order : {"usl", "musl", "usf"}) {
      const Words more = set({std::string("time.objective_rate=") + rate, "time.order=" + order,
                              "loading.final_strain=0.1", "loading.speed=0.5"});
      const Outcome outcome =
          run(folder, element(folder, "shear", audit(with_spin, "0"), joined(more, {"--driver", "mpm"})));
      EXPECT_EQ(outcome.code, 0) << rate << ", " << order << ": " << outcome.err;
    }
}

TEST(UmatDrivers, OfTheBiaxialTestTellAUmatOfStepsThatFollowEachOther) {
  const TemporaryFolder folder;
  const Outcome outcome = run(folder, biaxial(folder, audit("1", "0"), {"--threads", "2"}));
  EXPECT_EQ(outcome.code, 0) << outcome.err;
}

TEST(UmatDrivers, OfTheCheckTellAUmatOfStepsThatFollowEachOther) {
  const TemporaryFolder folder;
  const Outcome outcome = run(folder, joined({"umat-check", library("motion_umats")}, audit("1", "0")));
  EXPECT_EQ(outcome.code, 0) << outcome.err << outcome.out;
}

/// In parts, too, elastic shear is that of the whole step: each part rotates and strains by its share of the step.
TEST(UmatDrivers, GiveTheSameInStepsThatAreCut) {
  const TemporaryFolder folder;
  const Words shear = set({"loading.final_strain=0.3", "loading.normal_stress=1e5", "output.every_strain=0.01"});
  std::vector<double> ends;
  for (const std::string longest : {"0", "1e-3"}) {
    const Outcome outcome = run(folder, element(folder, "shear", joined(audit("0", longest), shear)));
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    ends.push_back(read_table(folder / "out" / "element.csv")["tau_Pa"].back());
  }
  EXPECT_NEAR(ends[1], ends[0], 1e-5 * ends[0]);
  EXPECT_GT(ends[0], 5e5);
}

/// A law in kPa, and one in Pa: the same stresses, waves and time steps.
TEST(UmatUnits, OfStressesMakeNoDifference) {
  const TemporaryFolder folder;
  std::vector<std::vector<double>> ends;
  for (const auto& [unit, E] : {std::pair{"Pa", "1e7"}, {"kPa", "1e4"}, {"MPa", "10"}}) {
    const Words law = joined(umat_named("motion_umats", "AGEING", std::string("[") + E + ",0.25]"),
                             set({std::string("material.stress_unit=") + unit}));
    const double sigma = last_stress(folder, element(folder, "triaxial", law, set({"loading.final_strain=0.01"})));
    const Outcome outcome = run(folder, biaxial(folder, law));
    ASSERT_EQ(outcome.code, 0) << unit << ": " << outcome.err;
    const auto history = read_table(folder / "out" / "history.csv");
    ends.push_back({sigma, history["force_N_per_m"].back(), history["time_step_s"].back()});
    for (std::size_t i = 0; i < ends.back().size(); ++i)
      EXPECT_NEAR(ends.back()[i], ends.front()[i], 1e-9 * ends.front()[i]) << unit << ", " << i;
  }
}

/// A declared stress among the states is in the UMAT's unit there, and in Pa in the program.
TEST(UmatUnits, OfDeclaredStressesAreTheUmats) {
  const TemporaryFolder folder;
  const Words kilopascals =
      joined(audit("1", "0"), set({"material.stress_unit=kPa", "material.parameters=[1e4,0.3,1,0]"}));
  const Outcome outcome = run(folder, element(folder, "shear", kilopascals, set({"loading.final_strain=0.01"})));
  EXPECT_EQ(outcome.code, 0) << outcome.err; // the audit compares it with STRESS
  const Outcome refused = run(folder, element(folder, "shear", kilopascals, set({"material.stress_unit=bar"})));
  EXPECT_EQ(refused.code, 2);
  EXPECT_THAT(refused.err, testing::AllOf(HasSubstr("material.stress_unit"), HasSubstr("kPa")));
}

/// Up to 512 numbers.
TEST(UmatStates, MayBeHundreds) {
  const TemporaryFolder folder;
  const auto states = [](int count) {
    std::string list = "[0";
    for (int i = 1; i < count; ++i) list += ",0";
    return set({"material.state=" + list + "]"});
  };
  const Words law = umat_named("motion_umats", "AGEING", "[1e7,0.3]");
  EXPECT_EQ(run(folder, biaxial(folder, law, joined(states(512), set({"output.vtk=false"})))).code, 0);
  const Outcome outcome = run(folder, biaxial(folder, law, states(513)));
  EXPECT_EQ(outcome.code, 2);
  EXPECT_THAT(outcome.err, HasSubstr("513 state variables are too many; allowed: 512"));
}

} // namespace
} // namespace riedel::test
