/// IncrementalDriver's files beyond plain steps: water, sines, deformation gradients, limits, UMATs.
#include "apps/incremental_folder.hpp"
#include "apps/program.hpp"

#include <gmock/gmock.h>

namespace riedel::test {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;

class IncrementalImport : public IncrementalFolder {
protected:
  /// Parameters with those of intergranular strain, switched off, and further ones.
  void add_parameters(const std::string& more, int count) const {
    std::string text = parameters_ + "0.1 m_R\n2.0\n1e-4\n0.5\n6.0\n" + more;
    text.replace(text.find("\n9\n"), 3, "\n" + std::to_string(count) + "\n");
    folder_.file("parameters.inp", text);
  }
  [[nodiscard]] ElementPath path(const std::string& test) const {
    write(test, -100.0);
    return element_path(ElementCase(imported().values));
  }
  /// Numbers of the last line of output.txt.
  [[nodiscard]] std::vector<double> last_of(const std::string& name) const {
    const Outcome outcome = run(folder_, {"element", "path", "--import", folder_.path().string(), "--out",
                                          (folder_ / name).string(), "--set", "output.plots=false"});
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    std::istringstream lines(file_content(folder_ / name / "output.txt"));
    std::string line, last;
    while (std::getline(lines, line)) last = line;
    std::istringstream numbers(last);
    return {std::istream_iterator<double>(numbers), {}};
  }
};

/// The fifteenth parameter: total stress = effective stress - K_w tr(strain), and the strains are the same without it.
TEST_F(IncrementalImport, WaterAddsItsPressureToTheStress) {
  const std::string test = "*OedometricE1\n100 10 1\n-0.002\n";
  write(test, -100.0);
  const std::vector<double> dry = last_of("dry");
  add_parameters("2.2e6 Kw\n", 15);
  const std::vector<double> wet = last_of("wet");
  ASSERT_EQ(wet.size(), dry.size() + 1);
  for (std::size_t c = 0; c < 3; ++c) EXPECT_NEAR(wet[8 + c], dry[8 + c] - 2.2e6 * 0.002, 1e-3 * -dry[8 + c]) << c;
  EXPECT_LT(wet[8], -4500.0);
  EXPECT_NEAR(wet[14 + 7], -4400.0, 0.01) << "statev(8)";
  EXPECT_NEAR(wet[14 + 6], dry[14 + 6], 1e-7) << "void ratio";
}

TEST_F(IncrementalImport, WaterHoldsTheVolumeOfATestWithoutDrainage) {
  write("*TriaxialE1\n100 10 1\n-0.02\n", -200.0);
  add_parameters("2.2e6 Kw\n0.65 e0\n", 16);
  folder_.file("initialconditions.inp", "3\n-200\n-200\n-200\n8\n0\n0\n0\n0\n0\n0\n0\n-100\n");
  const CheckedCase given = imported();
  EXPECT_EQ(given.values.number("specimen.void_ratio"), 0.65) << "statev(7) is 0: the sixteenth parameter";
  EXPECT_EQ(element_path(ElementCase(given.values)).stress.m[0], -100e3) << "effective: 100 of 200 kPa are the water's";
  const std::vector<double> last = last_of("out");
  EXPECT_NEAR(last[9], -200.0, 1e-3) << "total lateral stress";
  EXPECT_NEAR(last[2] + last[3] + last[4], 0.0, 1e-4);
  EXPECT_NEAR(last[14 + 7], -100.0 + 2.2e6 * (last[2] + last[3] + last[4]), 0.1);
  const std::string csv = file_content(folder_ / "out" / "element.csv");
  EXPECT_THAT(csv.substr(0, csv.find('\n')), testing::EndsWith(",p_Pa,q_Pa,pore_pressure_Pa"));
}

TEST_F(IncrementalImport, ReadsWhatStandsBehindTheTimeAndAnEndInAnyCase) {
  const ElementPath given = path("*oedometrice1\n1000 30 1.0: 10 # rows\n-0.05\n*TriaxialE1 ? -2*s1 > 400\n"
                                 "100 10 2.0 : 5 T 0\n-0.1\n*END\n*junk\n");
  ASSERT_EQ(given.stages.size(), 2U);
  EXPECT_EQ(given.stages[0].legs[0].duration, 1.0);
  ASSERT_TRUE(given.stages[1].until);
  EXPECT_EQ(given.stages[1].until->text(), "sigma_1 > 200000.0 Pa");
}

TEST_F(IncrementalImport, ConditionsBecomeLimitsInOurSigns) {
  for (const auto& [condition, limit] : {std::pair{"s1 < -200", "sigma_1 > 200000.0 Pa"},
                                         {"p<20 kPa", "p < 20000.0 Pa"},
                                         {"e2 > 0.01", "ln_2 < -0.01"},
                                         {"-g12 > 0.02", "ln_12 < -0.02"},
                                         {"2 * ev < 0.1", "ln_p < 0.05"}})
    EXPECT_EQ(path(std::string("*OedometricE1 ? ") + condition + "\n1 1 1\n-0.1\n").stages[0].until->text(), limit);
}

/// A sin(2 pi t / T + phase) added to the straight line; t counts from the start of the file.
TEST_F(IncrementalImport, CirculatingLoadsBecomeSines) {
  const std::string load = "*CirculatingLoad\n100 10 2.0\n*Cartesian\n1 -50 0.5 -10\n0 0 0 0\n0 0 0 0\n0 0.001 0 0\n"
                           "0 0 0 0\n0 0 0 0\n";
  const ElementPath given = path("*PureRelaxation\n1 1 4\n" + load + "*PureRelaxation\n1 1 0.5\n" + load);
  EXPECT_THAT(words(given.stages[1].legs[0]),
              ElementsAre("sigma_1=1e+04~5e+04@0.5", "ln_2=0", "ln_3=0", "ln_12=0~0.001@0", "ln_13=0", "ln_23=0"));
  EXPECT_THAT(words(given.stages[3].legs[0])[0], "sigma_1=1e+04~5e+04@2.07") << "a quarter of a period later";
  const ElementPath cycles = path("*Repetition\n1 7\n" + load);
  EXPECT_EQ(cycles.stages[0].repeat, 7);
  EXPECT_THAT(error("*Repetition\n2 7\n*PureRelaxation\n1 1 0.5\n" + load), HasSubstr("begins at another phase"));
}

TEST_F(IncrementalImport, ACirculatingLoadSwingsAsTheFormulaSays) {
  write("*CirculatingLoad\n100 10 1.0\n*Cartesian\n0 0.002 0 -0.001\n0 0 0 0\n0 0 0 0\n0 0 0 0\n0 0 0 0\n0 0 0 0\n",
        -100.0);
  (void)last_of("out");
  std::istringstream lines(file_content(folder_ / "out" / "output.txt"));
  std::string line;
  std::getline(lines, line);
  int rows = 0;
  while (std::getline(lines, line)) {
    std::istringstream numbers(line);
    const std::vector<double> row{std::istream_iterator<double>(numbers), {}};
    EXPECT_NEAR(row[2], 0.002 * std::sin(2 * std::numbers::pi * row[0]) - 0.001 * row[0], 1e-9);
    ++rows;
  }
  EXPECT_GT(rows, 20);
}

/// The order of the components, and a second such step: its time counts from 0.
TEST_F(IncrementalImport, DeformationGradientsAreGivenWhole) {
  const std::string load = "*DeformationGradient\n100 10 1.0\n0.9\n1.1\n1.0\n0.12\n0.21\n0.13\n0.31\n0.23\n0.32\n";
  const ElementPath given = path(load + load);
  Mat<3> F;
  F << 0.9, 0.12, 0.13, 0.21, 1.1, 0.23, 0.31, 0.32, 1.0;
  EXPECT_LT((*given.stages[0].legs[0].deformation - F).norm(), 1e-14);
  const Mat<3> twice = 2.0 * F - Mat<3>::Identity();
  EXPECT_LT((*given.stages[1].legs[0].deformation * F - twice).norm(), 1e-14);
  EXPECT_THAT(error("*DeformationGradient\n1 1 1\n-1\n1\n1\n0\n0\n0\n0\n0\n0\n"), HasSubstr("is not positive"));
  write("*DeformationGradient\n100 10 1.0\n0.99\n1\n1\n0\n0\n0\n0\n0\n0\n", -100.0);
  const std::vector<double> last = last_of("out");
  EXPECT_NEAR(last[2], std::log(0.99), 1e-8);
  EXPECT_LT(last[8], -300.0);
}

TEST_F(IncrementalImport, VariablesOfRoscoeAndRendulicAreTurned) {
  const std::string rows = "1 30\n1 60\n0 0.01\n0 0\n0 0\n0 0\n";
  EXPECT_THAT(words(path("*LinearLoad\n1 1 1\n*RoscoeIsomorph\n" + rows).stages[0].legs[0]),
              ElementsAre("p=1.73e+04", "q=7.35e+04", "ln_12=0", "ln_13=0", "ln_23=0", "ln_z=0.00707"));
  EXPECT_THAT(words(path("*LinearLoad\n1 1 1\n*Rendulic\n" + rows).stages[0].legs[0]),
              ElementsAre("sigma_1=3e+04", "sigma_2_plus_3=8.49e+04", "ln_12=0", "ln_13=0", "ln_23=0", "ln_z=0.00707"));
}

TEST_F(IncrementalImport, ParametersAndStateOfAUmatGoToItAsTheyAre) {
  write("*OedometricE1\n1 1 1\n-0.01\n", -100.0);
  folder_.file("parameters.inp", "my \"law\" # remark\n3\n1d3\n0.3\n-7 c\n");
  folder_.file("initialconditions.inp", "6\n-1\n-2\n-3\n4\n5\n6\n4\n0.1\n0.2\n0.7\n");
  CaseFile settings = CaseFile::empty();
  settings.override_with("material.library=mine.so");
  settings.override_with("material.state_names=a, b, void_ratio");
  const CaseFile given = import_incremental_driver(incremental_files({folder_.path().string()}), settings);
  EXPECT_EQ(given.peek_text("material.model"), "umat");
  EXPECT_EQ(given.peek_text("material.name"), "my \"law\"");
  Keys keys{{"material.parameters", std::vector<double>{}, "-", {}, "", {}, true},
            {"material.state", std::vector<double>{}, "-", {}, "", {}, true},
            {"initial.sigma", std::vector{0.0, 0.0, 0.0}, "Pa", {}, ""},
            {"initial.tau_23", 0.0, "Pa", {}, ""},
            {"specimen.void_ratio", 0.0, "-", {}, ""}};
  const Values values = given.check(keys).values;
  EXPECT_EQ(values.numbers("material.parameters"), (std::vector{1e3, 0.3, -7.0}));
  EXPECT_EQ(values.numbers("material.state"), (std::vector{0.1, 0.2, 0.7, 0.0})) << "what is missing is zero";
  EXPECT_EQ(values.numbers("initial.sigma"), (std::vector{1e3, 2e3, 3e3}));
  EXPECT_EQ(values.number("initial.tau_23"), 6e3);
  EXPECT_EQ(values.number("specimen.void_ratio"), 0.7);
}

TEST_F(IncrementalImport, FilesMayHaveOtherNames) {
  const std::string folder = folder_.path().string(), elsewhere = folder_.file("p.txt", "");
  const auto of = [](const std::vector<std::string>& wishes) { return incremental_files(wishes); };
  EXPECT_EQ(of({folder}).parameters, folder_ / "parameters.inp");
  EXPECT_EQ(of({folder, "test=other.inp"}).test, folder_ / "other.inp");
  EXPECT_EQ(of({folder, "param=" + elsewhere}).parameters, elsewhere);
  EXPECT_EQ(of({elsewhere}).test, elsewhere);
  EXPECT_EQ(of({elsewhere}).initial_conditions, folder_ / "initialconditions.inp");
  EXPECT_THAT([&] { (void)of({folder + "/none"}); },
              testing::ThrowsMessage<InputError>(HasSubstr("--import " + folder + "/none: there is no such folder")));
}

/// Nothing is ignored without an error.
TEST_F(IncrementalImport, RefusesByFileAndLineWhatItDoesNotCarry) {
  const std::string at = folder_.path().string() + "/test.inp:";
  for (const char* keyword :
       {"*ObeyRestrictions", "*ImportFile load.txt | 7", "*PerturbationsS", "*PerturbationsE", "*RandomWalk"})
    EXPECT_THAT(error(std::string(keyword) + "\n1 1 1\n"),
                AllOf(HasSubstr(at + "2: the keyword"), HasSubstr("known:")));
  const std::string step = "*OedometricE1\n";
  EXPECT_THAT(error(step + "1 1 1 T 20\n-0.1\n"), HasSubstr(at + "3: a change of temperature"));
  EXPECT_THAT(error(step + "1 1 1 : x\n-0.1\n"), HasSubstr(at + "3: 'x' is no number"));
  EXPECT_THAT(error(step + "1 1 0\n-0.1\n"), HasSubstr(at + "3: a time of 0.0; allowed: more than 0"));
  EXPECT_THAT(error(step + "1e300 1 1\n-0.1\n"), HasSubstr(at + "3: 1e+300 is not a number of increments"));
  EXPECT_THAT(error("*OedometricE1 ? s1-s3 > 5\n1 1 1\n-0.1\n"), HasSubstr(at + "4: the condition ' s1-s3 > 5'"));
  EXPECT_THAT(error("*Repetition\n1 2\n*OedometricE1 ? s1 > 5\n"), HasSubstr(at + "4: conditions that end a step"));
  EXPECT_THAT(error("*Repetition\n1 1e12\n"), HasSubstr(at + "3: 1e+12 is not a number of repetitions; allowed: an"));
  EXPECT_THAT(error("*Repetition\n1e9 1\n"), HasSubstr(at + "3: 1e+09 is not a number of steps; allowed: an integer"));
}

TEST_F(IncrementalImport, RefusesParametersAndStateThatItDoesNotKnow) {
  const auto says = [&](const std::string& more, int count, const std::string& state = "7\n0\n0\n0\n0\n0\n0\n0.6\n") {
    write("*PureRelaxation\n1 1 1\n", -100.0);
    add_parameters(more, count);
    folder_.file("initialconditions.inp", "3\n-100\n-100\n-100\n" + state);
    try {
      (void)imported();
    } catch (const InputError& error) { return std::string(error.what()); }
    return std::string("no error");
  };
  EXPECT_EQ(says("0\n", 15), "no error");
  EXPECT_THAT(says("-1\n", 15), HasSubstr("parameters.inp:17: a bulk modulus of water of -1.0"));
  EXPECT_THAT(says("", 15), HasSubstr("parameters.inp:16: the file ends where the bulk modulus of water is expected"));
  EXPECT_THAT(says("0\n0.6\n1\n", 17), HasSubstr("parameters.inp:2: 17 parameters are too many"));
  EXPECT_THAT(says("", 14, "14\n0\n0\n0\n0\n0\n0\n0.6\n0\n9\n9\n9\n9\n9\n3\n"),
              HasSubstr("statev(14) = 3.0 is not known"));
  EXPECT_THAT(says("", 14, "1e9\n"), HasSubstr("initialconditions.inp:5: 1e+09 is not the number of state variables"));
}

} // namespace
} // namespace riedel::test
