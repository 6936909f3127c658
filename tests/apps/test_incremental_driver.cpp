/// Paths in the files of IncrementalDriver.
#include "apps/incremental_folder.hpp"
#include "apps/program.hpp"
#include "support/csv.hpp"

#include <gmock/gmock.h>

namespace riedel::test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

using IncrementalDriver = IncrementalFolder;

TEST_F(IncrementalDriver, StepsBecomeChangesInOurSigns) {
  write("*TriaxialE1\n100 10 2.0\n-0.05\n*TriaxialUEq\n1 1 1\n0.01\n*TriaxialUq\n1 1 1\n20\n*Repetition\n2 3\n"
        "*OedometricS1\n9 9 1\n-50\n*LinearLoad\n9, 9, 1\n*Cartesian\n0 0.001\n1 -2\n0 0\n1 3\n0 0.002\n0 "
        "0\n*End\n*junk\n",
        -100.0);
  const CheckedCase given = imported();
  EXPECT_EQ(given.values.number("material.h_s"), 190e6);
  EXPECT_EQ(given.values.number("specimen.void_ratio"), 0.6);
  EXPECT_EQ(given.values.numbers("initial.sigma"), (std::vector{100e3, 100e3, 100e3}));
  const ElementPath path = element_path(ElementCase(given.values));
  ASSERT_EQ(path.stages.size(), 4U);
  EXPECT_THAT(words(path.stages[0].legs[0]),
              ElementsAre("sigma_2=0", "sigma_3=0", "ln_1=0.05", "ln_12=0", "ln_13=0", "ln_23=0"));
  EXPECT_EQ(path.stages[0].legs[0].duration, 2.0);
  EXPECT_TRUE(path.stages[0].legs[0].relative);
  EXPECT_FALSE(path.stages[0].legs[0].spin);
  EXPECT_THAT(words(path.stages[1].legs[0]),
              ElementsAre("ln_12=0", "ln_13=0", "ln_23=0", "ln_p=0", "ln_q=0.01", "ln_z=0"));
  EXPECT_THAT(words(path.stages[2].legs[0]),
              ElementsAre("q=2e+04", "ln_12=0", "ln_13=0", "ln_23=0", "ln_p=0", "ln_z=0"));
  EXPECT_EQ(path.stages[3].repeat, 3);
  ASSERT_EQ(path.stages[3].legs.size(), 2U);
  EXPECT_THAT(words(path.stages[3].legs[0]),
              ElementsAre("sigma_1=5e+04", "ln_2=0", "ln_3=0", "ln_12=0", "ln_13=0", "ln_23=0"));
  EXPECT_THAT(words(path.stages[3].legs[1]),
              ElementsAre("sigma_2=2e+03", "tau=3e+03", "ln_1=-0.001", "ln_3=0", "ln_13=0.002", "ln_23=0"));
}

TEST_F(IncrementalDriver, GivesTheReferenceCurveInItsOwnColumns) {
  const Table wanted = reference("gudehus_bauer_oedometer_e0.60_iso1kPa.csv");
  write("*OedometricE1\n100 10 1\n-" + exact_text(wanted.at("eps11_log").back()) + "\n");
  const Outcome outcome = run(folder_, {"element", "path", "--import", folder_.path().string(), "--out",
                                        (folder_ / "out").string(), "--set", "output.plots=false"});
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  std::istringstream lines(file_content(folder_ / "out" / "output.txt"));
  std::string line, last;
  std::getline(lines, line);
  EXPECT_THAT(line, HasSubstr("stran(6) stress(1)"));
  while (std::getline(lines, line)) last = line;
  std::istringstream numbers(last);
  std::vector<double> row{std::istream_iterator<double>(numbers), {}};
  ASSERT_EQ(row.size(), 2U + 6U + 6U + 8U);
  EXPECT_NEAR(row[2], -wanted.at("eps11_log").back(), 1e-9);
  EXPECT_NEAR(row[8], -1e-3 * wanted.at("sig11_Pa").back(), 1e-5 * 3000);
  EXPECT_NEAR(row[9], -1e-3 * wanted.at("sig22_Pa").back(), 1e-5 * 3000);
  EXPECT_EQ(row[14], 0.0) << "no intergranular strain";
  EXPECT_NEAR(row[14 + 6], wanted.at("e").back(), 1e-7);
}

TEST_F(IncrementalDriver, BringsIntergranularStrainAndItsStart) {
  write("*OedometricE1\n100 10 1\n-0.01\n", -100.0);
  std::string more = parameters_ + "5.0 m_R\n2.0 m_T\n2d-4 R\n0.4 beta_R\n5 chi\n";
  more.replace(more.find("\n9\n"), 3, "\n14\n");
  more.replace(more.find("0. p_t"), 2, "0.5");
  folder_.file("parameters.inp", more);
  folder_.file("initialconditions.inp", "6\n-100\n-100\n-100\n0\n0\n0\n7\n-1d-4\n1e-5\n0\n0\n0\n0\n0.6\n");
  const CheckedCase given = imported();
  EXPECT_TRUE(given.values.flag("material.intergranular_strain"));
  EXPECT_EQ(given.values.number("material.cohesion_pressure"), 500.0) << "p_t";
  EXPECT_EQ(given.values.number("material.R"), 2e-4);
  EXPECT_EQ(given.values.number("material.chi"), 5.0);
  EXPECT_EQ(given.values.numbers("initial.intergranular_strain"), (std::vector{1e-4, -1e-5, 0.0}));
  ASSERT_EQ(run(folder_, {"element", "path", "--import", folder_.path().string(), "--out", (folder_ / "out").string(),
                          "--set", "output.plots=false"})
                .code,
            0);
  std::istringstream lines(file_content(folder_ / "out" / "output.txt"));
  std::string line;
  std::getline(lines, line);
  std::getline(lines, line);
  std::istringstream first(line);
  std::vector<double> row{std::istream_iterator<double>(first), {}};
  ASSERT_EQ(row.size(), 2U + 6U + 6U + 8U);
  EXPECT_EQ(row[14], -1e-4);
  EXPECT_EQ(row[15], 1e-5);
  while (std::getline(lines, line))
    if (!line.empty()) first = std::istringstream(line);
  row.assign(std::istream_iterator<double>(first), {});
  EXPECT_NEAR(row[14], -2e-4, 1e-8) << "mobilised along the path: h_11 = -R";
}

TEST_F(IncrementalDriver, TellsFileAndLineOfWhatIsNotSupported) {
  const std::string at = folder_.path().string() + "/test.inp:";
  EXPECT_THAT(error("*TriaxialE2\n"), HasSubstr(at + "2: the keyword '*TriaxialE2' is not supported (did you mean "));
  EXPECT_THAT(error("*DeformationGradient\n"), HasSubstr(at + "2: the file ends where increments, iterations and a"));
  EXPECT_THAT(error("*TriaxialE1\n1 1 1\nmuch\n"), HasSubstr(at + "4: 'much' is no number"));
  EXPECT_THAT(error("*TriaxialE1\n1 1\n"), HasSubstr(at + "3: needs increments, iterations and a time"));
  EXPECT_THAT(error("*TriaxialE1\n1 1 1\n"), HasSubstr(at + "3: the file ends where a change is expected"));
  EXPECT_THAT(error("*LinearLoad\n1 1 1\n*Lode\n"), HasSubstr(at + "4: the variables '*Lode'"));
  EXPECT_THAT(error("*LinearLoad\n1 1 1\n*Cartesian\n2 1\n"), HasSubstr(at + "5: a condition begins with 0"));
}

TEST_F(IncrementalDriver, TellsOfParametersAndStartsThatAreNotSupported) {
  write("*End\n");
  const auto with = [&](const char* file, const std::string& text) {
    write("*PureRelaxation\n1 1 1\n");
    folder_.file(file, text);
    try {
      (void)imported();
    } catch (const InputError& error) { return std::string(error.what()); }
    return std::string("no error");
  };
  EXPECT_THAT(with("parameters.inp", "sand\n9\n"),
              HasSubstr("parameters.inp:1: no order of parameters is known for the "
                        "law 'sand'; known: von_wolffersdorff, gudehus_bauer"));
  EXPECT_THAT(with("parameters.inp", "gudehus_bauer\n8\n"), HasSubstr("parameters.inp:2: 8 parameters are too few"));
  std::string more = parameters_ + "5.0 m_R\n";
  more.replace(more.find("\n9\n"), 3, "\n14\n");
  EXPECT_THAT(with("parameters.inp", more), HasSubstr("parameters.inp:12: the file ends where m_T is expected"));
  more.replace(more.find("\n14\n"), 4, "\n12\n");
  EXPECT_THAT(with("parameters.inp", more), HasSubstr("parameters.inp:12: m_R = 5.0 asks for intergranular strain"));
  EXPECT_THAT(with("initialconditions.inp", "6\n-1\n-1\n-1\n0\n0\n0\n1\n0.6\n"),
              HasSubstr("initialconditions.inp:9: needs 7 state variables"));
  write("*PureRelaxation\n1 1 1\n", -100.0, "0.2");
  EXPECT_THROW((void)imported(), InputError); // below e_d
}

} // namespace
} // namespace riedel::test
