/// Numbers that are allowed but make no sense: a forgotten unit is reported before a run is wasted on it.
#include "apps/biaxial/patch.hpp"
#include "apps/biaxial/random_field_check.hpp"
#include "apps/biaxial/sense.hpp"
#include "apps/program.hpp"
#include "core/setup/random_field.hpp"
#include "support/patterns.hpp"
#include "verification/biaxial.hpp"

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

namespace riedel::test {
namespace {

using testing::AllOf;
using testing::ContainsRegex;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::StartsWith;

CheckedCase checked(const std::vector<std::string>& settings) {
  CaseFile file = CaseFile::empty();
  for (const std::string& setting : settings) file.override_with(setting);
  return biaxial_case(file, catalogue());
}
std::vector<std::string> warnings(const std::vector<std::string>& settings) { return checked(settings).warnings; }
std::string refusal(const std::vector<std::string>& settings) {
  try {
    (void)checked(settings);
  } catch (const InputError& error) { return error.what(); }
  return "no error";
}

TEST(Sense, RefusesALengthBeyondTheSpecimenAndTellsByHowMuch) {
  EXPECT_THAT(refusal({"nonlocal.length=1.5"}),
              AllOf(StartsWith("--set nonlocal.length: 1.5 m is 37.5 times the width of the specimen, 40 mm"),
                    HasSubstr("\"1.5 mm\"")));
  EXPECT_THAT(
      warnings({"nonlocal.length=15 mm"}),
      ElementsAre(AllOf(StartsWith("--set nonlocal.length: 0.015 m: the average extends"), HasSubstr("45 mm"))));
  EXPECT_THAT(warnings({"nonlocal.length=4 mm"}), IsEmpty());
}

TEST(Sense, WarnsOfLengthsPressuresSpeedsAndTimesInAnotherUnit) {
  const auto warning = [](const std::string& setting, const std::string& other = "nonlocal.length=0") {
    const std::vector<std::string> all = warnings({setting, other});
    return all.empty() ? std::string() : all.front();
  };
  EXPECT_THAT(warning("loading.confining_pressure=50"),
              AllOf(StartsWith("--set loading.confining_pressure: 50 Pa is less than the specimen's own weight at its "
                               "foot, 2.348 kPa"),
                    HasSubstr("\"50 kPa\"")));
  EXPECT_THAT(warning("loading.speed=10"),
              AllOf(StartsWith("--set loading.speed: 10.0 m/s is "), HasSubstr(" % of the speed of waves")));
  EXPECT_THAT(refusal({"loading.speed=2000"}), HasSubstr("--set loading.speed: 2000.0 m/s is faster than the waves"));
  EXPECT_THAT(warning("loading.ramp_time=5"),
              AllOf(StartsWith("--set loading.ramp_time: 5.0 s is 59.52 times"), HasSubstr("0.084 s")));
  EXPECT_THAT(warning("imperfection.correlation_length=5", "imperfection.deviation=0.001"),
              StartsWith("--set imperfection.correlation_length: 5.0 m is longer than the specimen, 140 mm"));
  EXPECT_THAT(warning("specimen.width=40"), StartsWith("--set specimen.width: a specimen of 40 m"));
  EXPECT_THAT(warning("imperfection.size=[1e-3,1e-3]", "imperfection.centre=[0.5,0.5]"),
              StartsWith("--set imperfection.size: the patch of 1 mm by 1 mm contains the centre of no point"));
  EXPECT_THAT(warning("grid.cells=[4,840]"), StartsWith("--set grid.cells: cells of 10 mm by 0.1667 mm are 60 times"));
  EXPECT_THAT(warning("output.every_strain=1e-9", "loading.speed=1e-4"), StartsWith("--set output.every_strain: "));
  EXPECT_THAT(refusal({"time.step=1"}),
              AllOf(StartsWith("--set time.step: 1.0 s is "), HasSubstr("times the stable time step")));
}

TEST(Sense, TheDefaultsAndShortTestsPass) {
  EXPECT_THAT(warnings({}), IsEmpty());
  EXPECT_THAT(warnings({"grid.cells=[4,8]", "loading.final_strain=0.002", "loading.speed=1", "nonlocal.length=0",
                        "imperfection.size=[0,0]"}),
              IsEmpty());
  EXPECT_THAT(warnings({"loading.ramp_time=0", "loading.gravity=0"}), IsEmpty());
}

TEST(Sense, WarnsOfARunThatTakesMoreThanADay) {
  EXPECT_THAT(warnings({"loading.speed=1e-5"}),
              ElementsAre(AllOf(StartsWith("--set loading.speed: the run takes more than a day: 2016 points, "),
                                ContainsRegex("steps of .* s, about [0-9.]+ (h|days) on one thread"))));
  EXPECT_THAT(warnings({"grid.cells=[2000,7000]", "nonlocal.length=0"}),
              testing::Contains(ContainsRegex("^--set grid.cells: .*takes more than a day: 14000000 points")));
}

TEST(Sense, CheckTellsWhatARunIsExpectedToTake) {
  const TemporaryFolder folder;
  const Outcome check = run(folder, {"check"});
  EXPECT_THAT(
      check.out,
      ContainsRegex("\n# What will run\n# expected: 2016 points, [0-9]+ steps of [0-9.e-]+ s, about "
                    "[0-9.]+ (s|min) on one thread\n# cells: 2016 .24 x 84. of 1.67 mm x 1.67 mm\n"
                    "# rates: damping [0-9.e+]+ 1/s, stresses filtered at [0-9.e+]+ 1/s, volumes at [0-9.e+]+ 1/s\n"
                    "# memory: about [0-9.]+ MB\n# threads: [0-9]+.*\n$"));
  EXPECT_EQ(check.err, "");
  EXPECT_THAT(
      run(folder, {"check", "--set", "time.step=5e-5", "--set", "grid.cells=[8,28]", "--set", "nonlocal.length=0"}).err,
      HasSubstr("warning: --set time.step: 5e-05 s is over the stable limit, 2.5"));
}

TEST(Sense, CheckTellsWhatAnElementTestIsExpectedToTake) {
  const TemporaryFolder folder;
  Words mpm, check{"check"}, element{"element", "biaxial", "--out", (folder / "out").string()};
  for (const char* setting :
       {"test=biaxial", "driver.kind=mpm", "grid.cells=2", "loading.final_strain=0.002", "output.plots=false"})
    mpm.insert(mpm.end(), {"--set", setting});
  check.insert(check.end(), mpm.begin(), mpm.end());
  element.insert(element.end(), mpm.begin(), mpm.end());
  const std::string told = run(folder, check).out, head = "# What will run\n# expected: 16 points, ";
  ASSERT_NE(told.find(head), std::string::npos) << told;
  EXPECT_THAT(told, ContainsRegex("# cells: 4 .2 x 2. of 5 mm\n# threads: [0-9]+"));
  ASSERT_EQ(run(folder, element).code, 0);
  const auto summary = json_of(folder / "out/summary.json");
  const double expected = std::stod(told.substr(told.find(head) + head.size())), made = summary["steps"];
  EXPECT_GT(expected, 0.7 * made);
  EXPECT_LT(expected, 2.0 * made);
  EXPECT_THAT(run(folder, {"check", "--set", "test=shear"}).out, HasSubstr("\n# expected: one point, without a grid"));
}

/// The sand stiffens while it is loaded, so that the steps lie between those of the start and those under load.
TEST(Sense, ExpectsAboutAsManyStepsAsTheRunMakes) {
  const BiaxialCase v =
      biaxial_values({"grid.cells=[8,28]", "nonlocal.length=0", "loading.final_strain=0.01", "loading.speed=0.5"});
  Simulation<2> simulation = make_biaxial(v, catalogue());
  const ExpectedWork expected = expected_work_of(v, catalogue());
  EXPECT_NEAR(expected.limit, simulation.crossing_time(), 0.05 * expected.limit);
  const auto speed = ramped(0.5, v.loading.ramp_time);
  double steps = 0.0;
  for (double u = 0.0; u < 0.01 * 0.14; ++steps) {
    simulation.step();
    u += speed(simulation.state().time) * simulation.time_step();
  }
  EXPECT_NEAR(expected.time, simulation.state().time, 0.02 * expected.time);
  EXPECT_LT(expected.steps, 2.0 * steps);
  EXPECT_GT(expected.steps, steps);
}

TEST(RandomField, OnALatticeIsTheFieldAtItsPlaces) {
  const VoidRatioField field = random_field(biaxial_values({"imperfection.deviation=0.01"}));
  const std::vector<double> x{0.001, 0.0123, 0.039}, y{0.002, 0.0777};
  const auto all = field.on_lattice(x, y);
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 2; ++j)
      EXPECT_NEAR(all(i, j), field({x[static_cast<std::size_t>(i)], y[static_cast<std::size_t>(j)]}), 1e-13);
}

/// Smallest void ratio over all points, found one by one.
double min_void_ratio(const BiaxialCase& v) {
  const VoidRatioField field = random_field(v);
  const double nx = static_cast<double>(v.grid.cells[0]), ny = static_cast<double>(v.grid.cells[1]);
  double minimum = 1.0;
  for (double i = 0.5; i < nx; ++i)
    for (double j = 0.5; j < ny; ++j) minimum = std::min(minimum, 0.55 + field({i * 0.04 / nx, j * 0.14 / ny}));
  return minimum;
}

/// The deviation at which a point just leaves the limits is the same whether all points are checked or few.
TEST(RandomField, IsRefusedFromTheDeviationOnAtWhichItsFirstPointLeavesTheLimits) {
  for (const std::string length : {"2e-2", "5e-3"}) {
    const std::vector<std::string> with{"grid.cells=[48,168]", "imperfection.size=[0,0]", "nonlocal.length=0",
                                        "imperfection.correlation_length=" + length};
    const auto and_deviation = [&](double deviation) {
      std::vector<std::string> all = with;
      all.push_back("imperfection.deviation=" + exact_text(deviation));
      return all;
    };
    const double e_d = 0.51 * std::exp(-std::pow(3.0 * 50e3 / 190e6, 0.5)), trial = 1e-3;
    const double critical = trial * (0.55 - e_d) / (0.55 - min_void_ratio(biaxial_values(and_deviation(trial))));
    EXPECT_EQ(refusal(and_deviation(critical * (1 - 1e-6))), "no error") << length;
    EXPECT_THAT(refusal(and_deviation(critical * (1 + 1e-6))), HasSubstr("the random field gives the point at ("));
  }
}

TEST(RandomField, OfMillionsOfPointsIsCheckedByThoseThatTell) {
  const std::vector<std::string> many{"grid.cells=[2000,2000]", "nonlocal.length=0"};
  const auto with = [&](const char* deviation) {
    std::vector<std::string> all = many;
    all.push_back(deviation);
    return all;
  };
  EXPECT_EQ(refusal(with("imperfection.deviation=0.01")), "no error");
  EXPECT_THAT(refusal(with("imperfection.deviation=0.03")), HasSubstr("the random field gives the point at ("));
}

} // namespace
} // namespace riedel::test
