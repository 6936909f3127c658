/// A UMAT with input for IncrementalDriver.
#include "plugin/umats.hpp"

#include <sstream>

namespace riedel::test {
namespace {

/// Parameters are PROPS, in the files' units: kPa, unless the settings say otherwise.
TEST(UmatImport, RunsTheUmatWithItsOwnParametersAndUnits) {
  const TemporaryFolder folder;
  (void)folder.file("parameters.inp", "HOOKE # of the example\n2\n2d4 E [kPa]\n0.25 nu\n");
  (void)folder.file("initialconditions.inp", "3\n-100\n-100\n-100\n0\n");
  (void)folder.file("test.inp", "out.txt\n*TriaxialE1\n100 10 1.0: 5\n-0.001\n*END\n");
  const Words words{"element",  "path",
                    "--import", folder.path().string(),
                    "--out",    (folder / "out").string(),
                    "--set",    "output.plots=false",
                    "--set",    "material.library=" + example("elastic_umat")};
  const Outcome outcome = run(folder, words);
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  std::istringstream lines(file_content(folder / "out" / "output.txt"));
  std::string line, last;
  while (std::getline(lines, line)) last = line;
  std::istringstream numbers(last);
  const std::vector<double> row{std::istream_iterator<double>(numbers), {}};
  ASSERT_EQ(row.size(), 2U + 6U + 6U) << "no state";
  EXPECT_NEAR(row[8], -100.0 - 2e4 * 0.001, 1e-4);
  EXPECT_NEAR(row[9], -100.0, 1e-4);
  EXPECT_NEAR(row[3], 0.25 * 0.001, 1e-8);
  EXPECT_NE(file_content(folder / "out" / "case.toml").find("name = \"HOOKE\""), std::string::npos);
}

} // namespace
} // namespace riedel::test
