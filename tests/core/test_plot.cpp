#include "core/base/error.hpp"
#include "core/draw/clip.hpp"
#include "core/draw/free_place.hpp"
#include "core/draw/plot.hpp"
#include "core/png_pixels.hpp"

#include <cmath>
#include <fstream>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <regex>

namespace riedel {
namespace {

namespace fs = std::filesystem;
using testing::ElementsAre;
using testing::HasSubstr;

class Plots : public testing::Test {
protected:
  fs::path path = fs::path(testing::TempDir()) /
                  (std::string("riedel_") + testing::UnitTest::GetInstance()->current_test_info()->name());
  void TearDown() override { fs::remove(path); }

  [[nodiscard]] std::string svg(const Plot& plot) const {
    write_svg(path, plot);
    std::ifstream in(path);
    return {std::istreambuf_iterator<char>(in), {}};
  }
};

Plot two_curves() {
  Plot plot;
  plot.title = "φ < 45° & e > 0.6";
  plot.x_label = "u/h₀ [-]";
  plot.y_label = "φ [°]";
  plot.series = {{"GIMP", {0, 1, 2}, {0, 30, 40}}, {"CPDI", {0, 1, 2}, {0, 20, 10}, Style::dashed}};
  plot.references = {{45, "peak"}};
  return plot;
}

std::vector<std::string> matches(const std::string& text, const std::string& pattern) {
  const std::regex expression(pattern);
  std::vector<std::string> found;
  for (std::sregex_iterator it(text.begin(), text.end(), expression), end; it != end; ++it) found.push_back((*it)[1]);
  return found;
}

std::vector<Spot> spots_of(const std::string& points) {
  std::istringstream in(std::regex_replace(points, std::regex(","), " "));
  std::vector<Spot> spots;
  for (Spot s; in >> s.x >> s.y;) spots.push_back(s);
  return spots;
}

std::string curve_points(const std::string& svg, const std::string& color) {
  const auto found = matches(svg, "<polyline points=\"([^\"]*)\" fill=\"none\" stroke=\"" + color +
                                      "\" stroke-width=\"1.8\"(?: stroke-dasharray=\"7 5\")?/>");
  return found.empty() ? "" : found[0]; // the second is the sample in the legend
}

/// Tags open and close in order, attributes are quoted, and text holds no bare < or &.
bool is_well_formed(const std::string& xml) {
  static const std::regex token(
      R"re(^(?:<\?xml[^>]*\?>|<(/?)(\w+)((?:\s+[\w:-]+="[^"<&]*")*)\s*(/?)>|[^<&]+|&(?:amp|lt|gt);))re");
  std::vector<std::string> open;
  std::string rest = xml;
  for (std::smatch m; !rest.empty(); rest = m.suffix()) {
    if (!std::regex_search(rest, m, token)) return false;
    if (!m[2].matched) continue;
    if (m[1].length() > 0) {
      if (open.empty() || open.back() != m[2]) return false;
      open.pop_back();
    } else if (m[4].length() == 0) {
      open.push_back(m[2]);
    }
  }
  return open.empty();
}

TEST_F(Plots, DrawEachCurveAsAPolylineInSvg) {
  const std::string text = svg(two_curves());
  const auto gimp = spots_of(curve_points(text, "#0072b2")), cpdi = spots_of(curve_points(text, "#d55e00"));
  ASSERT_EQ(gimp.size(), 3);
  ASSERT_EQ(cpdi.size(), 3);
  EXPECT_EQ(gimp[0].x, cpdi[0].x);
  EXPECT_NEAR(gimp[2].x - gimp[1].x, gimp[1].x - gimp[0].x, 0.02) << "x is to scale";
  EXPECT_NEAR((gimp[0].y - gimp[1].y) / (gimp[0].y - cpdi[1].y), 30.0 / 20, 1e-3) << "y is to scale";
  EXPECT_LT(gimp[2].y, gimp[1].y) << "y grows upwards";
}

TEST_F(Plots, AreWellFormedXmlWhateverTheirLabels) {
  const std::string text = svg(two_curves());
  EXPECT_TRUE(is_well_formed(text));
  EXPECT_THAT(text, HasSubstr(">φ &lt; 45° &amp; e &gt; 0.6</text>"));
  EXPECT_THAT(text, HasSubstr(">peak</text>"));
  EXPECT_FALSE(is_well_formed("<a><b></a>"));
  EXPECT_FALSE(is_well_formed("<a>&</a>"));
}

TEST_F(Plots, AreCutAtGivenAxes) {
  Plot plot = two_curves();
  plot.y_range = Interval{0, 35};
  plot.x_range = Interval{0, 2};
  const auto gimp = spots_of(curve_points(svg(plot), "#0072b2"));
  ASSERT_EQ(gimp.size(), 3);
  EXPECT_NEAR((gimp[2].x - gimp[1].x) / (gimp[1].x - gimp[0].x), 0.5, 1e-2) << "35 is half way from 30 to 40";
}

TEST_F(Plots, AreInterruptedByValuesThatAreNotFinite) {
  Plot plot;
  plot.series = {{"", {0, 1, 2, 3, 4}, {1, 2, std::nan(""), 2, 1}}};
  const auto pieces = matches(svg(plot), "<polyline points=\"([^\"]*)\" fill=\"none\" stroke=\"#0072b2\"");
  ASSERT_EQ(pieces.size(), 2);
  EXPECT_EQ(spots_of(pieces[0]).size(), 2);
}

TEST_F(Plots, HaveTheirCurvesColourInPng) {
  Plot plot;
  plot.series = {{"", {0, 1}, {0.5, 0.5}, Style::solid, Color{1, 0, 0}}};
  plot.y_range = Interval{0, 1};
  write_png(path, plot);
  PngPixels png(path);
  EXPECT_EQ(png.width(), 1600);
  EXPECT_EQ(png.height(), 1100);
  int rows = 0;
  for (int y = 0; y < png.height(); ++y) rows += png.count_in_row(y, 0xff0000) > 1200 ? 1 : 0;
  EXPECT_GE(rows, 3); // 1.8 × 2.5 pixels, without those that are partly covered
  EXPECT_LE(rows, 5);
}

TEST_F(Plots, NameAFileTheyCannotWriteAndACurveOfUnequalLengths) {
  Plot plot = two_curves();
  try {
    write_svg("/dev/null/a.svg", plot);
    FAIL();
  } catch (const RunError& error) { EXPECT_THAT(error.what(), HasSubstr("/dev/null/a.svg")); }
  plot.series[1].y.pop_back();
  EXPECT_THROW(write_png(path, plot), InputError);
}

TEST(Text, IsDrawnWithGreekLettersOrTheirNames) {
  for (const char* letter : {"φ", "θ", "γ", "σ", "ε", "ψ", "‖", "₀", "°", "−"}) {
    const TextMask mask = text_mask(letter, 40);
    int covered = 0;
    for (unsigned char cover : mask.cover) covered += cover > 128 ? 1 : 0;
    EXPECT_GT(covered, 20) << letter;
  }
  EXPECT_GT(text_width("φφ", 20), text_width("φ", 20));
}

TEST(Text, StandsOnItsBaseLine) {
  const auto lowest_ink = [](const TextMask& mask) {
    int lowest = 0;
    for (int row = 0; row < mask.height; ++row)
      for (int x = 0; x < mask.width; ++x)
        if (mask.cover[static_cast<std::size_t>(row * mask.width + x)] > 128) lowest = row;
    return lowest;
  };
  for (const char* text : {"H", "xz"}) {
    const TextMask mask = text_mask(text, 40);
    EXPECT_NEAR(lowest_ink(mask), mask.baseline - 1, 1) << text;
  }
  EXPECT_GT(lowest_ink(text_mask("p", 40)), text_mask("p", 40).baseline + 5);
}

TEST(Ticks, AreRoundAndWithinTheInterval) {
  EXPECT_THAT(tick_labels(round_ticks({0, 0.0507}, 6)), ElementsAre("0.00", "0.01", "0.02", "0.03", "0.04", "0.05"));
  EXPECT_THAT(tick_labels(round_ticks({-12, 31}, 4)), ElementsAre("−10", "0", "10", "20", "30"));
  EXPECT_THAT(tick_labels(round_ticks({0.1, 0.3}, 4)), ElementsAre("0.10", "0.15", "0.20", "0.25", "0.30"));
  EXPECT_THAT(tick_labels({0.0}), ElementsAre("0")) << "alone";
  EXPECT_THAT(tick_labels(round_ticks({-7, 45}, 1)), ElementsAre("0", "20", "40")) << "never one alone";
  EXPECT_THAT(tick_labels(round_ticks({0, 3e5}, 3)), ElementsAre("0", "1e5", "2e5", "3e5"));
}

TEST(Viridis, RunsFromDarkPurpleToYellowAndIsClamped) {
  for (double low : {0.0, -3.0}) EXPECT_NEAR(viridis(low).b, 0x54 / 255.0, 1e-12);
  for (double high : {1.0, 7.0}) EXPECT_NEAR(viridis(high).g, 0xe7 / 255.0, 1e-12);
  EXPECT_NEAR(viridis(0.5).r, 0x21 / 255.0, 1e-12);
}

TEST(Clip, KeepsThePiecesInsideTheBox) {
  const Box box{0, 0, 10, 10};
  const auto pieces = clip({{-5, 5}, {5, 5}, {5, 15}, {8, 15}, {8, 5}}, box);
  ASSERT_EQ(pieces.size(), 2);
  ASSERT_EQ(pieces[0].size(), 3);
  EXPECT_EQ(pieces[0][0].x, 0);
  EXPECT_EQ(pieces[0][2].y, 10);
  EXPECT_EQ(pieces[1][0].y, 10);
}

TEST(Clip, LeavesALineInsideTheBoxInOnePieceToTheBit) {
  std::vector<Spot> line;
  for (int i = 0; i < 200; ++i) line.push_back({0.1 * i, 10 + 7 * std::sin(0.37 * i)});
  const auto pieces = clip(line, {0, 0, 20, 20});
  ASSERT_EQ(pieces.size(), 1);
  ASSERT_EQ(pieces[0].size(), line.size());
  for (std::size_t i = 0; i < line.size(); ++i) EXPECT_TRUE(pieces[0][i].x == line[i].x && pieces[0][i].y == line[i].y);
}

TEST(Clip, CutsNoSpotThatLiesOutsideTheBox) {
  const Box box{0.1, 0.1, 0.7, 0.7};
  for (int i = 0; i < 200; ++i) {
    const double out = 1 + 0.013 * i, in = 0.2 + 0.002 * i;
    const auto part = clip(Spot{in, 0.3}, Spot{out, 0.3 + 0.001 * i}, box);
    ASSERT_TRUE(part);
    EXPECT_LE(part->second.x, box.right);
  }
}

TEST(FreePlace, AvoidsCurvesAndBoxes) {
  const Box area{0, 0, 100, 100};
  const auto top_right = free_place(area, 20, 10, 2, {});
  ASSERT_TRUE(top_right);
  EXPECT_EQ(top_right->right, 98);
  EXPECT_EQ(top_right->top, 2);
  const auto elsewhere = free_place(area, 20, 10, 2, {{{{50, 5}, {100, 5}}}, {{0, 0, 30, 30}}});
  ASSERT_TRUE(elsewhere);
  EXPECT_TRUE(elsewhere->top > 5 || elsewhere->right < 50);
  EXPECT_TRUE(elsewhere->top > 30 || elsewhere->left > 30);
  EXPECT_FALSE(free_place(area, 98, 10, 2, {}));
}

TEST_F(Plots, ALogarithmicAxisPutsEqualFactorsEquallyFarApart) {
  Plot plot;
  plot.log_x = true;
  plot.series = {{"", {0, 1, 10, 1000}, {5, 1, 2, 3}}}; // 0 has no logarithm
  const std::string text = svg(plot);
  const auto spots = spots_of(curve_points(text, "#0072b2"));
  ASSERT_EQ(spots.size(), 3U);
  EXPECT_NEAR(spots[2].x - spots[1].x, 2 * (spots[1].x - spots[0].x), 0.2);
  for (const char* label : {">1<", ">10<", ">100<", ">1000<"}) EXPECT_THAT(text, HasSubstr(label));
}

TEST(Scale, LogarithmicTicksAreFinerOverAShortAxis) {
  EXPECT_THAT(log_tick_labels(log_ticks({0, 4})), ElementsAre("1", "10", "100", "1000", "10000"));
  EXPECT_THAT(log_tick_labels(log_ticks({1.2, 2.4})), ElementsAre("20", "50", "100", "200"));
}

} // namespace
} // namespace riedel
