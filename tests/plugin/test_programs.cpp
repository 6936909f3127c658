/// The example programs, built out of tree against the installed library, do what their first lines say.
#include "core/io/table.hpp"
#include "temporary_folder.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <gtest/gtest.h>

namespace riedel::test {
namespace {

namespace fs = std::filesystem;

/// history.csv of a program that has run.
Table history_of(const std::string& program, const TemporaryFolder& here) {
  const std::string folder = (here / "out").string();
  EXPECT_EQ(std::system((std::string(PLUGINS) + "/programs/" + program + " " + folder).c_str()), 0);
  for (const char* file : {"points.pvd", "domains.pvd", "points/points_000010.vtp"})
    EXPECT_TRUE(fs::exists(fs::path(folder) / file)) << file;
  return read_table(fs::path(folder) / "history.csv");
}

TEST(Programs, LetADiscFallOnABedAndJump) {
  const TemporaryFolder here;
  const Table history = history_of("falling_disc", here);
  const std::vector<double>& height = history["disc_m"];
  EXPECT_NEAR(height.front(), 1.2, 0.01);
  const auto lowest = std::ranges::min_element(height);
  EXPECT_LT(*lowest, 0.82);
  EXPECT_GT(*lowest, 0.6);
  EXPECT_GT(*std::max_element(lowest, height.end()), *lowest + 0.1) << "it jumps";
}

TEST(Programs, LetAColumnOfSandCollapse) {
  const TemporaryFolder here;
  const Table history = history_of("column_collapse", here);
  EXPECT_NEAR(history["front_m"].front(), 0.2, 0.006);
  EXPECT_GT(history["front_m"].back(), 0.4);
  EXPECT_LT(history["height_m"].back(), 0.3);
  EXPECT_LT(history["kinetic_J_per_m"].back(), 0.05 * std::ranges::max(history["kinetic_J_per_m"]))
      << "it comes to rest";
}

/// Settlement of a column whose modulus grows as 1 + κ s/p0 with its vertical stress s: the strain is
/// (p0/κM) ln(1 + κ s/p0).
TEST(Programs, LetABlockOfAnOwnLawSettleAsTheClosedFormHasIt) {
  const TemporaryFolder here;
  const Table history = history_of("own_law", here);
  constexpr double E = 2e5, nu = 0.3, weight = 1000.0 * 9.81, p0 = 1e3;
  const double M = E * (1.0 - nu) / ((1.0 + nu) * (1.0 - 2.0 * nu)), kappa = (1.0 + nu) / (3.0 * (1.0 - nu));
  double settlement = 0.0;
  constexpr int slices = 1000;
  for (int i = 0; i < slices; ++i) {
    const double s = weight * (i + 0.5) / slices;
    settlement += (1.0 - std::pow(1.0 + kappa * s / p0, -p0 / (kappa * M))) / slices;
  }
  const double settled = history["height_m"].front() - history["height_m"].back();
  EXPECT_NEAR(settled, settlement, 0.01 * settlement);
  EXPECT_GT(settlement, 0.005);
}

} // namespace
} // namespace riedel::test
