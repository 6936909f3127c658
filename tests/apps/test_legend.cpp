/// Names and styles of runs in a legend.
#include "core/campaign/legend.hpp"

#include "apps/biaxial/keys.hpp"
#include "support/problems.hpp"

#include <gmock/gmock.h>
#include <set>

namespace riedel::test {
namespace {

using Settings = std::vector<Setting>;

/// Of the biaxial test.
std::string label(const Settings& settings) {
  static const Keys keys = biaxial_keys(catalogue(), paper_model);
  return legend_label(settings, keys);
}

std::vector<std::string> schemes() { return catalogue().in_2d.schemes.names(); }

std::vector<Pen> pens(const std::vector<Settings>& runs) { return pens_of(runs, schemes()); }

TEST(Legend, CallsQuantitiesByTheirSymbolsInUnitsThatAreRead) {
  EXPECT_EQ(label({{"scheme", "gimp"}, {"nonlocal.length", "0.004"}}), "gimp, l_c = 4 mm");
  EXPECT_EQ(label({{"nonlocal.length", "0"}}), "local");
  for (const char* length : {"2.5e-3", "2.5mm", "\"2.5 mm\""})
    EXPECT_EQ(label({{"nonlocal.length", length}}), "l_c = 2.5 mm");
  EXPECT_EQ(label({{"specimen.void_ratio", "0.55"}, {"grid.cells", "[24, 84]"}}), "e₀ = 0.55, 24×84 cells");
  EXPECT_EQ(label({{"loading.confining_pressure", "50e3"}}), "σ_c = 50 kPa");
  EXPECT_EQ(label({{"loading.confining_pressure", "\"0.2 MPa\""}}), "σ_c = 200 kPa");
  EXPECT_EQ(label({{"time.step", "1e-6"}}), "Δt = 1e−6 s");
  EXPECT_EQ(label({{"time.step", "\"auto\""}}), "Δt = auto");
}

TEST(Legend, CallsOtherKeysByTheirLastWordWithTheirUnit) {
  EXPECT_EQ(label({{"loading.lateral", "points"}}), "lateral = points");
  EXPECT_EQ(label({{"loading.ramp_time", "5e-3"}}), "ramp_time = 0.005 s");
  EXPECT_EQ(label({{"material.plugin", "a"}, {"nonlocal.plugin", "b"}}), "material.plugin = a, nonlocal.plugin = b");
  EXPECT_EQ(label({}), "");
}

std::vector<Settings> crossed(const std::vector<std::string>& schemes, int lengths) {
  std::vector<Settings> runs;
  for (const std::string& scheme : schemes)
    for (int i = 0; i < lengths; ++i) runs.push_back({{"scheme", scheme}, {"nonlocal.length", std::to_string(i)}});
  return runs;
}

bool same_color(const Pen& a, const Pen& b) {
  return a.color.r == b.color.r && a.color.g == b.color.g && a.color.b == b.color.b;
}

TEST(Pens, HaveAColourForEachSchemeAndDashesForTheRest) {
  const std::vector<Settings> runs = crossed({"gimp", "cpdi", "linear"}, 3);
  const std::vector<Pen> drawn = pens(runs);
  for (std::size_t i = 0; i < runs.size(); ++i)
    for (std::size_t k = 0; k < i; ++k) {
      EXPECT_EQ(same_color(drawn[i], drawn[k]), runs[i][0] == runs[k][0]);
      EXPECT_EQ(drawn[i].dashes == drawn[k].dashes, runs[i][1] == runs[k][1]);
    }
}

TEST(Pens, GiveASchemeTheSameColourInEveryPlot) {
  const Pen few = pens(crossed({"linear", "cpdi"}, 1))[1], many = pens(crossed({"bspline3", "gimp", "cpdi"}, 4))[8];
  EXPECT_TRUE(same_color(few, many));
  std::vector<std::string> all = schemes();
  EXPECT_TRUE(same_color(few, {palette_color(color_of_scheme(all, "cpdi")), 1, {}}));
}

TEST(Pens, HaveAColourForEachValueWhereOneSchemeIsUsed) {
  const std::vector<Pen> drawn = pens(crossed({"gimp"}, 3));
  EXPECT_FALSE(same_color(drawn[0], drawn[1]));
  EXPECT_FALSE(same_color(drawn[1], drawn[2]));
  EXPECT_TRUE(drawn[0].dashes.empty());
  EXPECT_EQ(drawn[0].dashes, drawn[2].dashes);
  EXPECT_EQ(pens(crossed({"gimp"}, 1)).size(), 1U);
  EXPECT_TRUE(pens(std::vector<Settings>{}).empty());
}

TEST(Pens, DoNotRepeatThemselvesTooSoon) {
  const std::vector<Pen> drawn = pens(crossed({"linear", "gimp", "cpdi"}, 12));
  std::set<std::tuple<double, double, double, std::vector<double>>> different;
  for (const Pen& pen : drawn) different.insert({pen.color.r, pen.color.g, pen.color.b, pen.dashes});
  EXPECT_EQ(different.size(), drawn.size());
}

} // namespace
} // namespace riedel::test
