#include "core/io/plot.hpp"

#include "core/base/error.hpp"
#include "core/io/atomic_file.hpp"
#include "core/io/clip.hpp"
#include "core/io/free_place.hpp"
#include "core/io/raster_canvas.hpp"

#include <array>
#include <cmath>

namespace riedel {
namespace {

/// Okabe and Ito (2008), less the yellow, which is too faint for a line on white.
constexpr std::array<Color, 7> palette{{{0, 0.447, 0.698},
                                        {0.835, 0.369, 0},
                                        {0, 0.620, 0.451},
                                        {0.8, 0.475, 0.655},
                                        {0.902, 0.624, 0},
                                        {0.337, 0.706, 0.914},
                                        {0.2, 0.2, 0.2}}};
constexpr Color faint{0.90, 0.90, 0.90}, grey{0.45, 0.45, 0.45};
constexpr double small = 12, large = 14; ///< sizes of ticks and legend, of title
constexpr double label_gap = 3;
constexpr double tick = 5, gap = 6, thin = 0.8;       ///< ticks, spaces, axes
constexpr double sample = 26, row = 1.5 * small;      ///< line shown in the legend, its rows
constexpr double curve_width = 1.8, dot_radius = 2.4; ///< curves

struct Curve {
  const Series* series;
  Pen pen;
  std::vector<Spot> spots; ///< on the sheet, before they are cut
};

/// Places on the sheet for the values of a plot.
struct Axes {
  Interval x, y; ///< x of logarithms, where the axis is logarithmic
  Box area;
  bool log_x;
  [[nodiscard]] double across(double value) const { return along(log_x ? std::log10(value) : value); }
  [[nodiscard]] double along(double place) const { return area.left + x.part(place) * area.width(); }
  [[nodiscard]] double down(double value) const { return area.bottom - y.part(value) * area.height(); }
};

Interval x_interval(const Plot& plot) {
  Extent extent;
  for (const Series& s : plot.series)
    for (double value : s.x) extent.add(plot.log_x ? std::log10(value) : value);
  if (!plot.log_x) return plot.x_range.value_or(extent.interval(0.02));
  if (plot.x_range) return {std::log10(plot.x_range->low), std::log10(plot.x_range->high)};
  return extent.interval(0.0);
}

Interval y_interval(const Plot& plot) {
  Extent extent;
  for (const Series& s : plot.series)
    for (double value : s.y) extent.add(value);
  for (const ReferenceLine& line : plot.references) extent.add(line.y);
  return plot.y_range.value_or(extent.interval(0.06));
}

double widest(const std::vector<std::string>& texts) {
  double width = 0;
  for (const std::string& text : texts) width = std::max(width, text_width(text, small));
  return width;
}

Box area_of(const Plot& plot, const Interval& y, double right_margin) {
  const double ticks = widest(tick_labels(round_ticks(y, 6)));
  const double label = plot.y_label.empty() ? 0 : small + 2 * gap;
  const double title = plot.title.empty() ? 0 : large + 2 * gap;
  return {gap + label + ticks + tick + gap, 2 * gap + title, plot.width - right_margin - 3 * gap,
          plot.height - tick - 2 * small - 4 * gap};
}

Pen pen_of(const Series& series, std::size_t number) {
  Pen pen = series_pen(number);
  if (series.color) pen.color = *series.color;
  if (series.style == Style::solid && !series.color) return pen;
  pen.dashes.clear();
  if (series.style == Style::dashed) pen.dashes = {7, 5};
  if (series.style == Style::dotted) pen.dashes = {0.1, 4};
  return pen;
}

std::vector<Curve> curves_of(const Plot& plot, const Axes& axes) {
  std::vector<Curve> curves;
  for (const Series& s : plot.series) {
    if (s.x.size() != s.y.size())
      throw InputError("the curve '" + s.label + "' has " + std::to_string(s.x.size()) + " x and " +
                       std::to_string(s.y.size()) + " y");
    Curve curve{&s, pen_of(s, curves.size()), {}};
    for (std::size_t i = 0; i < s.x.size(); ++i) {
      const Spot spot{axes.across(s.x[i]), axes.down(s.y[i])};
      constexpr double fine = 0.2; // steps too short to be seen only make the file longer
      const bool visible = curve.spots.empty() || i + 1 == s.x.size() ||
                           !(std::hypot(spot.x - curve.spots.back().x, spot.y - curve.spots.back().y) < fine);
      if (visible) curve.spots.push_back(spot);
    }
    curves.push_back(std::move(curve));
  }
  return curves;
}

void draw_axes(Canvas& canvas, const Plot& plot, const Axes& axes) {
  const Box& a = axes.area;
  const auto x_ticks = axes.log_x ? log_ticks(axes.x) : round_ticks(axes.x, 7), y_ticks = round_ticks(axes.y, 6);
  const auto x_labels = axes.log_x ? log_tick_labels(x_ticks) : tick_labels(x_ticks), y_labels = tick_labels(y_ticks);
  const Pen axis{ink, thin};
  for (std::size_t i = 0; i < y_ticks.size(); ++i) {
    const double y = axes.down(y_ticks[i]);
    canvas.line({{a.left, y}, {a.right, y}}, {faint, thin});
    canvas.line({{a.left - tick, y}, {a.left, y}}, axis);
    canvas.text({a.left - tick - 4, y + 0.36 * small}, y_labels[i], {small, ink, Anchor::end});
  }
  for (std::size_t i = 0; i < x_ticks.size(); ++i) {
    const double x = axes.along(x_ticks[i]);
    canvas.line({{x, a.bottom}, {x, a.bottom + tick}}, axis);
    canvas.text({x, a.bottom + tick + 3 + small}, x_labels[i], {small, ink, Anchor::middle});
  }
  canvas.line({{a.left, a.top}, {a.left, a.bottom}, {a.right, a.bottom}}, axis);
  const double x = (a.left + a.right) / 2, y = (a.top + a.bottom) / 2;
  canvas.text({x, plot.height - 2 * gap}, plot.x_label, {small, ink, Anchor::middle});
  canvas.text({gap + small, y}, plot.y_label, {small, ink, Anchor::middle, true});
  canvas.text({x, 2 * gap + large}, plot.title, {large, ink, Anchor::middle});
}

void draw_curves(Canvas& canvas, const std::vector<Curve>& curves, const Box& area) {
  for (const Curve& curve : curves) {
    canvas.belongs_to(curve.series->id);
    if (curve.series->style == Style::dots) {
      for (const Spot& s : curve.spots)
        if (clip(s, s, area)) canvas.disc(s, dot_radius, curve.pen.color);
    } else {
      for (const auto& piece : clip(curve.spots, area)) canvas.line(piece, curve.pen);
    }
  }
  canvas.belongs_to("");
}

struct Layout {
  Axes axes;
  std::vector<Curve> curves;
  std::vector<Box> reference_labels; ///< one for each reference line
  std::vector<const Curve*> legend;
  std::optional<Box> legend_place;
};

/// A label stands on its line at the right end, or wherever else no curve passes.
Box reference_place(const ReferenceLine& line, const Axes& axes, const Occupied& occupied) {
  const Box& area = axes.area;
  const double y = axes.down(line.y), width = text_width(line.label, small), height = small + 2 * label_gap;
  const Box above{area.left, y - height, area.right, y}, below{area.left, y, area.right, y + height};
  if (const auto place = free_place(above, width, small, label_gap, occupied)) return *place;
  if (const auto place = free_place(below, width, small, label_gap, occupied)) return *place;
  return {area.right - width - gap, y - small - label_gap, area.right - gap, y - label_gap};
}

/// @param beside whether the legend stands at the right of the axes instead of among the curves
Layout lay_out(const Plot& plot, bool beside) {
  Layout layout;
  std::vector<std::string> labels;
  for (const Series& s : plot.series)
    if (!s.label.empty()) labels.push_back(s.label);
  const double width = sample + gap + widest(labels), height = row * static_cast<double>(labels.size());

  layout.axes = {x_interval(plot), y_interval(plot), {}, plot.log_x};
  layout.axes.area = area_of(plot, layout.axes.y, beside ? width + 2 * gap : 0);
  layout.curves = curves_of(plot, layout.axes);
  Occupied occupied;
  for (const Curve& curve : layout.curves) {
    occupied.lines.push_back(curve.spots);
    if (!curve.series->label.empty()) layout.legend.push_back(&curve);
  }
  for (const ReferenceLine& line : plot.references) {
    layout.reference_labels.push_back(reference_place(line, layout.axes, occupied));
    occupied.boxes.push_back(layout.reference_labels.back());
    const double y = layout.axes.down(line.y);
    occupied.lines.push_back({{layout.axes.area.left, y}, {layout.axes.area.right, y}});
  }
  const Box& area = layout.axes.area;
  if (beside) {
    layout.legend_place = {area.right + 2 * gap, area.top, area.right + 2 * gap + width, area.top + height};
  } else {
    layout.legend_place = free_place(area, width, height, gap, occupied);
  }
  return layout;
}

void draw_references(Canvas& canvas, const Plot& plot, const Layout& layout) {
  const Box& area = layout.axes.area;
  for (std::size_t i = 0; i < plot.references.size(); ++i) {
    const double y = layout.axes.down(plot.references[i].y);
    if (!clip({area.left, y}, {area.right, y}, area)) continue;
    canvas.line({{area.left, y}, {area.right, y}}, {grey, 1, {2, 3}});
    const Box& place = layout.reference_labels[i];
    canvas.text({place.left, place.bottom - 0.2 * small}, plot.references[i].label, {small, grey});
  }
}

void draw_legend(Canvas& canvas, const Layout& layout) {
  Spot corner{layout.legend_place->left, layout.legend_place->top};
  for (const Curve* curve : layout.legend) {
    const double y = corner.y + row / 2;
    if (curve->series->style == Style::dots) {
      canvas.disc({corner.x + sample / 2, y}, dot_radius, curve->pen.color);
    } else {
      canvas.line({{corner.x, y}, {corner.x + sample, y}}, curve->pen);
    }
    canvas.text({corner.x + sample + gap, y + 0.36 * small}, curve->series->label, {small});
    corner.y += row;
  }
}

void draw(Canvas& canvas, const Plot& plot) {
  Layout layout = lay_out(plot, false);
  if (!layout.legend_place) layout = lay_out(plot, true);
  draw_axes(canvas, plot, layout.axes);
  draw_references(canvas, plot, layout);
  draw_curves(canvas, layout.curves, layout.axes.area);
  draw_legend(canvas, layout);
}

} // namespace

Pen series_pen(std::size_t number) {
  const std::array<std::vector<double>, 4> dashes{{{}, {6, 4}, {0.1, 3.5}, {9, 4, 0.1, 4}}};
  return {palette[number % palette.size()], curve_width, dashes[number / palette.size() % dashes.size()]};
}

std::string svg_text(const Plot& plot) {
  const auto canvas = make_svg_canvas(plot.width, plot.height);
  draw(*canvas, plot);
  return canvas->encode();
}

void write_svg(const std::filesystem::path& path, const Plot& plot) { write_atomically(path, svg_text(plot)); }

void write_png(const std::filesystem::path& path, const Plot& plot) {
  RasterCanvas canvas(plot.width, plot.height, 2.5);
  draw(canvas, plot);
  write_atomically(path, canvas.encode());
}

} // namespace riedel
