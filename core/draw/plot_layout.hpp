/// Positions of all parts of a plot on its sheet.
#pragma once

#include "core/draw/plot.hpp"

namespace riedel {

constexpr double small_font = 12, large_font = 14; ///< of ticks, labels and legend; of the title
constexpr double tick_length = 5, gap = 6;
constexpr double legend_sample = 26, legend_row = 1.5 * small_font; ///< length of line samples, height of rows
constexpr double line_of_text = 1.25;                               ///< from one line to the next, in font sizes

struct PlotAxis {
  Interval range; ///< of decimal logarithms if the axis is logarithmic, like the ticks
  bool logarithmic = false;
  std::vector<double> ticks = {};
  std::vector<std::string> labels = {};

  [[nodiscard]] double part(double value) const;
};

/// Maps the values of a plot to positions on the sheet.
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
  std::vector<Spot> spots; ///< on the sheet, before clipping
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

/// @throws InputError if a curve has different numbers of x and y values
PlotLayout lay_out(const Plot& plot);

} // namespace riedel
