/// How runs are called and drawn in a legend.
#include "apps/report/legend.hpp"

#include <gmock/gmock.h>
#include <set>

namespace riedel::test {
namespace {

using Settings = std::vector<Setting>;

TEST(Legend, CallsQuantitiesByTheirSymbolsInUnitsThatAreRead) {
  EXPECT_EQ(legend_label({{"scheme", "gimp"}, {"nonlocal.length", "0.004"}}), "gimp, l_c = 4 mm");
  EXPECT_EQ(legend_label({{"nonlocal.length", "0"}}), "local");
  for (const char* length : {"2.5e-3", "2.5mm", "\"2.5 mm\""})
    EXPECT_EQ(legend_label({{"nonlocal.length", length}}), "l_c = 2.5 mm");
  EXPECT_EQ(legend_label({{"specimen.void_ratio", "0.55"}, {"grid.cells", "[24, 84]"}}), "e₀ = 0.55, 24×84 cells");
  EXPECT_EQ(legend_label({{"loading.confining_pressure", "50e3"}}), "σ_c = 50 kPa");
  EXPECT_EQ(legend_label({{"loading.confining_pressure", "\"0.2 MPa\""}}), "σ_c = 200 kPa");
  EXPECT_EQ(legend_label({{"time.step", "1e-6"}}), "Δt = 1e−6 s");
  EXPECT_EQ(legend_label({{"time.step", "\"auto\""}}), "Δt = auto");
}

TEST(Legend, CallsOtherKeysByTheirLastWordWithTheirUnit) {
  EXPECT_EQ(legend_label({{"loading.lateral", "points"}}), "lateral = points");
  EXPECT_EQ(legend_label({{"loading.ramp_time", "5e-3"}}), "ramp_time = 0.005 s");
  EXPECT_EQ(legend_label({{"material.plugin", "a"}, {"nonlocal.plugin", "b"}}),
            "material.plugin = a, nonlocal.plugin = b");
  EXPECT_EQ(legend_label({}), "");
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
  const std::vector<Pen> pens = pens_of(runs);
  for (std::size_t i = 0; i < runs.size(); ++i)
    for (std::size_t k = 0; k < i; ++k) {
      EXPECT_EQ(same_color(pens[i], pens[k]), runs[i][0] == runs[k][0]);
      EXPECT_EQ(pens[i].dashes == pens[k].dashes, runs[i][1] == runs[k][1]);
    }
}

TEST(Pens, GiveASchemeTheSameColourInEveryPlot) {
  const Pen few = pens_of(crossed({"linear", "cpdi"}, 1))[1],
            many = pens_of(crossed({"bspline3", "gimp", "cpdi"}, 4))[8];
  EXPECT_TRUE(same_color(few, many));
  EXPECT_TRUE(same_color(few, {palette_color(color_of_scheme("cpdi")), 1, {}}));
}

TEST(Pens, HaveAColourForEachValueWhereOneSchemeIsUsed) {
  const std::vector<Pen> pens = pens_of(crossed({"gimp"}, 3));
  EXPECT_FALSE(same_color(pens[0], pens[1]));
  EXPECT_FALSE(same_color(pens[1], pens[2]));
  EXPECT_TRUE(pens[0].dashes.empty());
  EXPECT_EQ(pens[0].dashes, pens[2].dashes);
  EXPECT_EQ(pens_of(crossed({"gimp"}, 1)).size(), 1U);
  EXPECT_TRUE(pens_of(std::vector<Settings>{}).empty());
}

TEST(Pens, DoNotRepeatThemselvesTooSoon) {
  const std::vector<Pen> pens = pens_of(crossed({"linear", "gimp", "cpdi"}, 12));
  std::set<std::tuple<double, double, double, std::vector<double>>> different;
  for (const Pen& pen : pens) different.insert({pen.color.r, pen.color.g, pen.color.b, pen.dashes});
  EXPECT_EQ(different.size(), pens.size());
}

} // namespace
} // namespace riedel::test
