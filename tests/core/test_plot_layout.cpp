/// The layout of a plot: no part is cut off or overlaps another, whatever the texts and the numbers.
#include "core/draw/plot_layout.hpp"
#include "core/draw/text_lines.hpp"
#include "support/patterns.hpp"

#include <cmath>
#include <gmock/gmock.h>
#include <limits>

namespace riedel {
namespace {

using testing::HasSubstr;
using testing::SizeIs;

constexpr double nothing = std::numeric_limits<double>::quiet_NaN();
const std::string long_text =
    "Plane strain compression of dense sand between rigid platens under a confining pressure of 50 kPa, with a loose "
    "patch "
    "in the middle of its left side, in a specimen that is taller than any that was tested before";

Plot plot_of(const std::vector<double>& x, const std::vector<double>& y) {
  return {.title = "title", .x_label = "x", .y_label = "y", .series = {{"curve", x, y}}};
}

Plot many_runs(std::size_t count, const std::string& label) {
  Plot plot{.title = "title", .x_label = "x", .y_label = "y", .series = {}};
  for (std::size_t i = 0; i < count; ++i)
    plot.series.push_back({label + std::to_string(i), {0, 1, 2}, {0.0, double(i), double(i % 7)}});
  return plot;
}

void expect_on_sheet(const Box& box, const PlotLayout& l) {
  EXPECT_GE(box.left, 0);
  EXPECT_GE(box.top, 0);
  EXPECT_LE(box.right, l.width + 0.01);
  EXPECT_LE(box.bottom, l.height + 0.01);
}

bool overlap(const Box& a, const Box& b) {
  return a.left < b.right && b.left < a.right && a.top < b.bottom && b.top < a.bottom;
}

Box box_of(const LegendEntry& entry) {
  const double width = legend_sample + gap + widest(entry.lines, small_font);
  return {entry.corner.x, entry.corner.y, entry.corner.x + width,
          entry.corner.y + small_font * line_of_text * double(entry.lines.size())};
}

/// Tick labels do not overlap, differ, and are on the sheet, as is the legend.
void expect_readable(const Plot& plot) {
  const PlotLayout l = lay_out(plot);
  const Box& area = l.axes.area;
  EXPECT_GT(area.width(), 0.3 * l.width);
  EXPECT_GT(area.height(), 0.3 * plot.height);
  expect_on_sheet(area, l);
  double last = -1e9;
  for (std::size_t i = 0; i < l.axes.x.ticks.size(); ++i) {
    const double x = l.axes.across(l.axes.x.range.part(l.axes.x.ticks[i]));
    const double half = 0.5 * text_width(l.axes.x.labels[i], small_font);
    expect_on_sheet({x - half, area.bottom, x + half, area.bottom + small_font}, l);
    EXPECT_GT(x - half, last) << l.axes.x.labels[i];
    last = x + half;
  }
  EXPECT_GE(area.left - tick_length - widest(l.axes.y.labels, small_font), 0);
  for (const PlotAxis* axis : {&l.axes.x, &l.axes.y}) {
    EXPECT_GE(axis->ticks.size(), 1U);
    EXPECT_LE(axis->ticks.size(), 14U);
    for (std::size_t i = 1; i < axis->labels.size(); ++i) EXPECT_NE(axis->labels[i], axis->labels[i - 1]);
  }
  EXPECT_LE(widest(l.title, large_font), l.width);
  EXPECT_LE(widest(l.x_label, small_font), l.width);
  std::vector<Box> boxes;
  for (const LegendEntry& entry : l.legend) {
    boxes.push_back(box_of(entry));
    expect_on_sheet(boxes.back(), l);
    for (std::size_t k = 0; k + 1 < boxes.size(); ++k) EXPECT_FALSE(overlap(boxes.back(), boxes[k]));
  }
}

TEST(PlotLayout, KeepsLongTextsOnTheSheet) {
  Plot plot = plot_of({0, 1}, {0, 1});
  plot.title = plot.x_label = plot.y_label = long_text;
  expect_readable(plot);
  const PlotLayout l = lay_out(plot);
  EXPECT_THAT(l.title, SizeIs(3));
  EXPECT_GT(l.y_label.size(), 1U);
  plot.title = std::string(300, 'w'); // one word
  expect_readable(plot);
}

TEST(PlotLayout, FindsRoomForManyRunsAndForLongNames) {
  for (const std::size_t count : {2U, 9U, 30U})
    for (const std::string& label :
         {std::string("run "), std::string("bspline3, l_c = 2.5 mm, e₀ = 0.55, 24×84 cells, no. "), long_text})
      expect_readable(many_runs(count, label));
}

TEST(PlotLayout, LeavesTheAxesTheirSizeWhereTheLegendStandsBeneath) {
  const PlotLayout few = lay_out(many_runs(1, "")), many = lay_out(many_runs(60, "a run with a name "));
  EXPECT_EQ(few.height, 440);
  EXPECT_GT(many.height, 500);
  EXPECT_EQ(few.axes.area.height(), many.axes.area.height());
}

TEST(PlotLayout, CopesWithEveryRangeOfNumbers) {
  const std::vector<std::vector<double>> ranges{{0, 0},
                                                {5, 5},
                                                {-3, -3},
                                                {58.0, 58.0 + 1e-9},
                                                {0, 1e-12},
                                                {-1e-12, 1e-12},
                                                {1e5, 1e5 + 1e-4},
                                                {-2e7, -1e7},
                                                {-1e300, 1e300},
                                                {1e-320, 2e-320},
                                                {nothing, 1},
                                                {nothing, nothing},
                                                {std::numeric_limits<double>::infinity(), 1}};
  for (const auto& x : ranges)
    for (const auto& y : ranges) {
      SCOPED_TRACE(testing::PrintToString(x) + " " + testing::PrintToString(y));
      expect_readable(plot_of(x, y));
    }
}

TEST(PlotLayout, CopesWithEveryRangeOfLogarithms) {
  for (const std::vector<double>& range : std::vector<std::vector<double>>{{1, 1},
                                                                           {1, 10},
                                                                           {100, 112},
                                                                           {1e-12, 1e12},
                                                                           {1e-300, 1e300},
                                                                           {0, 5},
                                                                           {-1, -2},
                                                                           {1e4, 1e4 + 1e-6},
                                                                           {nothing, 3}}) {
    Plot plot = plot_of(range, range);
    plot.log_x = plot.log_y = true;
    SCOPED_TRACE(testing::PrintToString(range));
    expect_readable(plot);
  }
}

TEST(PlotLayout, PutsTicksWhereItIsTold) {
  Plot plot = plot_of({8, 16, 32}, {1, 0.25, 0.0625});
  plot.log_x = plot.log_y = true;
  plot.x_ticks = {8, 16, 32, 64};
  const PlotLayout l = lay_out(plot);
  EXPECT_THAT(l.axes.x.labels, testing::ElementsAre("8", "16", "32")); // 64 is off the axis
  const std::vector<Spot>& spots = l.curves[0].spots;
  EXPECT_NEAR(spots[1].x - spots[0].x, spots[2].x - spots[1].x, 1e-9);
  EXPECT_NEAR(spots[1].y - spots[0].y, spots[2].y - spots[1].y, 1e-9) << "a power is a straight line";
  EXPECT_GT(spots[1].y, spots[0].y + 10);
}

TEST(PlotDrawing, SaysWhereThereIsNothing) {
  EXPECT_THAT(svg_text({.title = "t", .x_label = "", .y_label = "", .series = {}}), HasSubstr(">no data</text>"));
  EXPECT_THAT(svg_text(plot_of({0, 1}, {0, 1})), testing::Not(HasSubstr("no data")));
}

std::ptrdiff_t count(const std::string& text, const std::string& pattern) {
  return std::ssize(test::matches_in(text, pattern));
}

TEST(PlotDrawing, ShowsAPointThatStandsAlone) {
  EXPECT_EQ(count(svg_text(plot_of({0, 1, 2, 3}, {1, nothing, 2, 3})), "<circle"), 1);
  EXPECT_EQ(count(svg_text(plot_of({0}, {1})), "<circle"), 1);
  EXPECT_EQ(count(svg_text(plot_of({0, 1}, {1, 2})), "<circle"), 0);
}

TEST(PlotDrawing, MarksEveryPointWithItsMarker) {
  for (const auto& [marker, pattern] : {std::pair{Marker::disc, "<circle"}, {Marker::square, "stroke-width=\"1.4\""}}) {
    Plot plot = plot_of({0, 1, 2}, {1, 5, 2});
    plot.series[0].marker = marker;
    EXPECT_EQ(count(svg_text(plot), pattern), 4) << "three points and the legend";
  }
}

TEST(TextLines, PartBetweenWordsAndEndInDots) {
  const double two_words = text_width("aa bb", 12) + 1;
  EXPECT_THAT(lines_of("aa bb cc", 12, two_words, 5), testing::ElementsAre("aa bb", "cc"));
  EXPECT_THAT(lines_of("aa bb cc dd ee", 12, two_words, 2), testing::ElementsAre("aa bb", testing::EndsWith("…")));
  EXPECT_THAT(lines_of("", 12, 100, 2), testing::IsEmpty());
  for (const std::string& line : lines_of("φφφφφφφφφφφφφφφφφφφφ", 12, 50, 9)) {
    EXPECT_LE(text_width(line, 12), 50);
    EXPECT_EQ(line.size() % 2, 0U) << "a letter is cut in two";
  }
}

TEST(Ticks, HaveLabelsThatDiffer) {
  EXPECT_THAT(tick_labels(round_ticks({0, 1e-12}, 4)),
              testing::ElementsAre("0", "0.2e−12", "0.4e−12", "0.6e−12", "0.8e−12", "1.0e−12"));
  EXPECT_THAT(tick_labels(round_ticks({58.0, 58.0 + 4e-9}, 4)),
              testing::ElementsAre("58.000000000", "58.000000001", "58.000000002", "58.000000003", "58.000000004"));
}

TEST(PlainNumber, HasTheFewestDigits) {
  EXPECT_EQ(plain_number(4.0), "4");
  EXPECT_EQ(plain_number(1e3 * 0.0025), "2.5");
  EXPECT_EQ(plain_number(1e-6), "1e−6");
  EXPECT_EQ(plain_number(-0.5), "−0.5");
  EXPECT_EQ(plain_number(2e6), "2e6");
}

} // namespace
} // namespace riedel
