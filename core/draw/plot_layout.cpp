#include "core/draw/plot_layout.hpp"

#include "core/base/error.hpp"
#include "core/draw/free_place.hpp"
#include "core/draw/text_lines.hpp"

#include <algorithm>
#include <cmath>

namespace riedel {

namespace {

constexpr double label_gap = 3;
constexpr double most_beside = 0.45; ///< largest share of the sheet's width for a legend beside the axes
constexpr double text_space = line_of_text * small_font;
constexpr std::size_t max_lines = 3;

PlotAxis x_axis(const Plot& plot) {
  Extent extent;
  for (const Series& s : plot.series)
    for (const double value : s.x) extent.add(plot.log_x ? std::log10(value) : value);
  PlotAxis axis{extent.interval(plot.log_x ? 0.0 : 0.02), plot.log_x};
  if (plot.x_range)
    axis.range = plot.log_x ? Interval{std::log10(plot.x_range->low), std::log10(plot.x_range->high)} : *plot.x_range;
  return axis;
}

PlotAxis y_axis(const Plot& plot) {
  const auto place = [&](double value) { return plot.log_y ? std::log10(value) : value; };
  Extent extent;
  for (const Series& s : plot.series)
    for (const double value : s.y) extent.add(place(value));
  for (const ReferenceLine& line : plot.references) extent.add(place(line.y));
  PlotAxis axis{extent.interval(plot.log_y ? 0.0 : 0.06), plot.log_y};
  const double margin = 0.06 * axis.range.width();
  if (plot.log_y) axis.range = {axis.range.low - margin, axis.range.high + margin};
  if (plot.y_range) axis.range = {place(plot.y_range->low), place(plot.y_range->high)};
  axis.ticks = axis.logarithmic ? log_ticks(axis.range) : round_ticks(axis.range, 6);
  axis.labels = axis.logarithmic ? log_tick_labels(axis.ticks) : tick_labels(axis.ticks);
  return axis;
}

/// As many ticks as have room for their labels.
void put_x_ticks(PlotAxis& axis, const Plot& plot, double width) {
  for (int about = 7; about > 0; --about) {
    axis.ticks.clear();
    for (const double value : plot.x_ticks)
      if (const double part = axis.part(value); part >= 0.0 && part <= 1.0)
        axis.ticks.push_back(axis.logarithmic ? std::log10(value) : value);
    if (axis.ticks.empty())
      axis.ticks = axis.logarithmic ? log_ticks(axis.range, about) : round_ticks(axis.range, about);
    axis.labels = axis.logarithmic ? log_tick_labels(axis.ticks) : tick_labels(axis.ticks);
    double step = width;
    for (std::size_t i = 1; i < axis.ticks.size(); ++i)
      step = std::min(step, width * (axis.ticks[i] - axis.ticks[i - 1]) / axis.range.width());
    if (widest(axis.labels, small_font) + small_font <= step || !plot.x_ticks.empty()) return;
  }
  axis.ticks.resize(std::min<std::size_t>(axis.ticks.size(), 1));
  axis.labels.resize(axis.ticks.size());
}

/// Texts around the axes, and the room left for the axes.
void frame_axes(PlotLayout& l, const Plot& plot, double right_margin) {
  l.title = lines_of(plot.title, large_font, l.width - 4 * gap, max_lines);
  l.x_label = lines_of(plot.x_label, small_font, l.width - 4 * gap, max_lines);
  const double above =
      2 * gap + (l.title.empty() ? 0 : static_cast<double>(l.title.size()) * line_of_text * large_font + gap);
  const double label_rows = static_cast<double>(std::max<std::size_t>(l.x_label.size(), 1));
  const double below = tick_length + small_font + label_rows * text_space + 3 * gap;
  l.y_label = lines_of(plot.y_label, small_font, plot.height - above - below, max_lines);
  const double label = l.y_label.empty() ? 0 : static_cast<double>(l.y_label.size()) * text_space + 1.5 * gap;
  Box& area = l.axes.area;
  area = {2 * gap + label + widest(l.axes.y.labels, small_font) + tick_length, above, l.width - right_margin - 3 * gap,
          plot.height - below};
  put_x_ticks(l.axes.x, plot, area.width());
  // Half of a label at an end of the axis extends beyond it.
  for (std::size_t i = 0; i < l.axes.x.ticks.size(); ++i) {
    const double half = 0.5 * text_width(l.axes.x.labels[i], small_font) + 2;
    const double x = l.axes.across((l.axes.x.ticks[i] - l.axes.x.range.low) / l.axes.x.range.width());
    area.left = std::max(area.left, area.left + half - x);
    area.right = std::min(area.right, area.right + l.width - right_margin - x - half);
  }
}

std::vector<Curve> curves_of(const Plot& plot, const PlotAxes& axes) {
  std::vector<Curve> curves;
  for (const Series& s : plot.series) {
    if (s.x.size() != s.y.size())
      throw InputError("the curve '" + s.label + "' has " + std::to_string(s.x.size()) + " x values and " +
                       std::to_string(s.y.size()) + " y values");
    Curve curve{&s, pen_of(s, curves.size()), {}};
    for (std::size_t i = 0; i < s.x.size(); ++i) {
      const Spot spot = axes.spot(s.x[i], s.y[i]);
      constexpr double fine = 0.2; // invisibly short steps only make the file longer
      const bool visible = curve.spots.empty() || i + 1 == s.x.size() || s.marker != Marker::none ||
                           !(std::hypot(spot.x - curve.spots.back().x, spot.y - curve.spots.back().y) < fine);
      if (visible) curve.spots.push_back(spot);
    }
    curves.push_back(std::move(curve));
  }
  return curves;
}

/// The label of a reference line is on the line at the right end, or wherever no curve passes.
Box reference_place(const std::string& label, double y, const Box& area, const Occupied& occupied) {
  const double width = text_width(label, small_font), height = small_font + 2 * label_gap;
  const Box above{area.left, y - height, area.right, y}, below{area.left, y, area.right, y + height};
  if (const auto place = free_place(above, width, small_font, label_gap, occupied)) return *place;
  if (const auto place = free_place(below, width, small_font, label_gap, occupied)) return *place;
  return {area.right - width - gap, y - small_font - label_gap, area.right - gap, y - label_gap};
}

/// Curves and the labels of reference lines within the axes. @return the areas they occupy
Occupied fill_axes(PlotLayout& l, const Plot& plot) {
  Occupied occupied;
  const Box& area = l.axes.area;
  l.curves = curves_of(plot, l.axes);
  for (const Curve& curve : l.curves) occupied.lines.push_back(curve.spots);
  l.reference_labels.clear();
  for (const ReferenceLine& line : plot.references) {
    const double y = l.axes.down(l.axes.y.part(line.y));
    l.reference_labels.push_back(reference_place(line.label, y, area, occupied));
    occupied.boxes.push_back(l.reference_labels.back());
    occupied.lines.push_back({{area.left, y}, {area.right, y}});
  }
  return occupied;
}

/// Entries in columns of the given number and width, row by row with the given number of lines.
void put_legend(PlotLayout& l, Spot corner, std::size_t columns, double column_width, double row) {
  for (std::size_t i = 0; i < l.legend.size(); ++i)
    l.legend[i].corner = {corner.x + static_cast<double>(i % columns) * column_width,
                          corner.y + static_cast<double>(i / columns) * row};
}

void put_legend_beneath(PlotLayout& l, double entry_width) {
  const double room = l.width - 4 * gap, column = std::min(entry_width, room) + 3 * gap;
  const auto columns = static_cast<std::size_t>(std::max(1.0, std::floor((room + 3 * gap) / column)));
  std::size_t lines = 1;
  for (LegendEntry& entry : l.legend) {
    entry.lines = lines_of(entry.curve->series->label, small_font, room - legend_sample - gap, max_lines);
    lines = std::max(lines, entry.lines.size());
  }
  const double row = legend_row + static_cast<double>(lines - 1) * text_space;
  put_legend(l, {2 * gap, l.height}, columns, column, row);
  l.height += std::ceil(static_cast<double>(l.legend.size()) / static_cast<double>(columns)) * row + 2 * gap;
}

} // namespace

double PlotAxis::part(double value) const { return range.part(logarithmic ? std::log10(value) : value); }

PlotLayout lay_out(const Plot& plot) {
  PlotLayout l;
  l.width = plot.width;
  l.height = plot.height;
  l.axes = {x_axis(plot), y_axis(plot), {}};
  std::vector<std::string> labels;
  for (const Series& s : plot.series)
    if (!s.label.empty()) labels.push_back(s.label);
  const double width = legend_sample + gap + widest(labels, small_font);
  const double height = legend_row * static_cast<double>(labels.size());

  frame_axes(l, plot, 0.0);
  const std::optional<Box> place =
      labels.empty() ? std::nullopt : free_place(l.axes.area, width, height, gap, fill_axes(l, plot));
  const bool beside =
      !labels.empty() && !place && width <= most_beside * l.width && l.axes.area.top + height <= l.height - gap;
  if (beside) frame_axes(l, plot, width + 2 * gap);
  (void)fill_axes(l, plot);
  for (const Curve& curve : l.curves)
    if (!curve.series->label.empty()) l.legend.push_back({&curve, {curve.series->label}, {}});
  l.legend_box = place;
  if (place)
    put_legend(l, {place->left, place->top}, 1, 0.0, legend_row);
  else if (beside)
    put_legend(l, {l.width - width - 2 * gap, l.axes.area.top}, 1, 0.0, legend_row);
  else if (!labels.empty())
    put_legend_beneath(l, width);
  return l;
}

} // namespace riedel
