/// Where everything of a plot stands on its sheet.
#pragma once

#include "core/draw/plot.hpp"

namespace riedel {

constexpr double small_font = 12, large_font = 14; ///< sizes of ticks, labels and legend; of the title
constexpr double tick_length = 5, gap = 6;
constexpr double legend_sample = 26, legend_row = 1.5 * small_font; ///< line shown in the legend, its rows
constexpr double line_of_text = 1.25;                               ///< from one line to the next, in sizes of the font

struct PlotAxis {
  Interval range; ///< of decimal logarithms where the axis is logarithmic, as are the ticks
  bool logarithmic = false;
  std::vector<double> ticks = {};
  std::vector<std::string> labels = {};

  [[nodiscard]] double part(double value) const;
};

/// Places on the sheet for the values of a plot.
struct PlotAxes {
  PlotAxis x, y;
  Box area;
  [[nodiscard]] Spot spot(double at_x, double at_y) const { return {across(x.part(at_x)), down(y.part(at_y))}; }
  [[nodiscard]] double across(double part) const { return area.left + part * area.width(); }
  [[nodiscard]] double down(double part) const { return area.bottom - part * area.height(); }
};

struct Curve {
  const Series* series;
  Pen pen;
  std::vector<Spot> spots; ///< on the sheet, before they are cut
};

struct LegendEntry {
  const Curve* curve;
  std::vector<std::string> lines;
  Spot corner; ///< upper left
};

struct PlotLayout {
  double width = 0, height = 0; ///< of the sheet
  std::vector<std::string> title, x_label, y_label;
  PlotAxes axes;
  std::vector<Curve> curves;
  std::vector<Box> reference_labels; ///< one for each reference line
  std::vector<LegendEntry> legend;
  std::optional<Box> legend_box; ///< among the curves
};

/// @throws InputError if a curve has not as many x as y
PlotLayout lay_out(const Plot& plot);

} // namespace riedel
