#include "core/draw/plot.hpp"

#include "core/draw/clip.hpp"
#include "core/draw/plot_layout.hpp"
#include "core/draw/raster_canvas.hpp"
#include "core/io/atomic_file.hpp"

#include <algorithm>
#include <cmath>

namespace riedel {
namespace {

constexpr Color faint{0.90, 0.90, 0.90}, grey{0.45, 0.45, 0.45};
constexpr Color shade{0.88, 0.88, 0.88};
constexpr double thin = 0.8; ///< axes
constexpr double dot_radius = 2.4;

/// Lines of text stacked downwards. @param at base line of the first
void draw_lines(Canvas& canvas, Spot at, const std::vector<std::string>& lines, const Lettering& lettering) {
  const double step = line_of_text * lettering.size;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    const double down = static_cast<double>(i) * step;
    canvas.text(lettering.upright ? Spot{at.x + down, at.y} : Spot{at.x, at.y + down}, lines[i], lettering);
  }
}

/// Centre of a text of that width, as near to the given position as the sheet allows.
double within_sheet(double middle, const std::vector<std::string>& lines, double size, double sheet) {
  double half = 0;
  for (const std::string& line : lines) half = std::max(half, 0.5 * text_width(line, size));
  return std::clamp(middle, std::min(half + gap, sheet / 2), std::max(sheet - half - gap, sheet / 2));
}

void draw_ticks(Canvas& canvas, const PlotAxes& axes) {
  const Box& a = axes.area;
  const Pen axis{ink, thin};
  for (std::size_t i = 0; i < axes.y.ticks.size(); ++i) {
    const double y = axes.down(axes.y.range.part(axes.y.ticks[i]));
    canvas.line({{a.left, y}, {a.right, y}}, {faint, thin});
    canvas.line({{a.left - tick_length, y}, {a.left, y}}, axis);
    canvas.text({a.left - tick_length - 4, y + 0.36 * small_font}, axes.y.labels[i], {small_font, ink, Anchor::end});
  }
  for (std::size_t i = 0; i < axes.x.ticks.size(); ++i) {
    const double x = axes.across(axes.x.range.part(axes.x.ticks[i]));
    canvas.line({{x, a.bottom}, {x, a.bottom + tick_length}}, axis);
    canvas.text({x, a.bottom + tick_length + 3 + small_font}, axes.x.labels[i], {small_font, ink, Anchor::middle});
  }
  canvas.line({{a.left, a.top}, {a.left, a.bottom}, {a.right, a.bottom}}, axis);
}

void draw_shaded(Canvas& canvas, const Plot& plot, const PlotAxes& axes) {
  const Box& a = axes.area;
  for (const ShadedBox& box : plot.shaded) {
    const auto across = [&](double x) { return std::clamp(axes.across(axes.x.part(x)), a.left, a.right); };
    const auto down = [&](double y) { return std::clamp(axes.down(axes.y.part(y)), a.top, a.bottom); };
    const Box place{across(box.x.low), down(box.y.high), across(box.x.high), down(box.y.low)};
    if (!(place.width() > 0.0) || !(place.height() > 0.0)) continue;
    canvas.rectangle(place, shade);
    canvas.text({place.left + gap, place.top + small_font + 2}, box.label, {small_font, grey});
  }
}

void draw_axes(Canvas& canvas, const PlotLayout& l) {
  const Box& a = l.axes.area;
  draw_ticks(canvas, l.axes);
  const double x = (a.left + a.right) / 2;
  const double below = a.bottom + tick_length + 3 + small_font + gap + small_font;
  draw_lines(canvas, {within_sheet(x, l.x_label, small_font, l.width), below}, l.x_label,
             {small_font, ink, Anchor::middle});
  draw_lines(canvas, {gap + small_font, (a.top + a.bottom) / 2}, l.y_label, {small_font, ink, Anchor::middle, true});
  draw_lines(canvas, {within_sheet(x, l.title, large_font, l.width), 2 * gap + large_font}, l.title,
             {large_font, ink, Anchor::middle});
  if (std::ranges::none_of(l.curves, [](const Curve& curve) { return !curve.spots.empty(); }))
    canvas.text({x, (a.top + a.bottom) / 2}, "no data", {small_font, grey, Anchor::middle});
}

bool finite(const Spot& s) { return std::isfinite(s.x) && std::isfinite(s.y); }

/// Isolated points within the area: no line reaches them, since their neighbours are not finite.
std::vector<Spot> alone(const std::vector<Spot>& spots, const Box& area) {
  std::vector<Spot> found;
  for (std::size_t i = 0; i < spots.size(); ++i)
    if (finite(spots[i]) && (i == 0 || !finite(spots[i - 1])) && (i + 1 == spots.size() || !finite(spots[i + 1])) &&
        clip(spots[i], spots[i], area))
      found.push_back(spots[i]);
  return found;
}

void draw_curves(Canvas& canvas, const std::vector<Curve>& curves, const Box& area) {
  for (const Curve& curve : curves) {
    canvas.belongs_to(curve.series->id);
    const bool dots = curve.series->style == Style::dots;
    if (!dots) {
      for (const auto& piece : clip(curve.spots, area)) canvas.line(piece, curve.pen);
      for (const Spot& s : alone(curve.spots, area)) canvas.disc(s, dot_radius, curve.pen.color);
    }
    for (const Spot& s : curve.spots) {
      if (!finite(s) || !clip(s, s, area)) continue;
      if (dots && curve.series->marker == Marker::none) canvas.disc(s, dot_radius, curve.pen.color);
      draw_marker(canvas, curve.series->marker, s, curve.pen.color);
    }
  }
  canvas.belongs_to("");
}

void draw_references(Canvas& canvas, const Plot& plot, const PlotLayout& layout) {
  const Box& area = layout.axes.area;
  for (std::size_t i = 0; i < plot.references.size(); ++i) {
    const double y = layout.axes.down(layout.axes.y.part(plot.references[i].y));
    if (!std::isfinite(y) || !clip({area.left, y}, {area.right, y}, area)) continue;
    canvas.line({{area.left, y}, {area.right, y}}, {grey, 1, {2, 3}});
    const Box& place = layout.reference_labels[i];
    canvas.text({place.left, place.bottom - 0.2 * small_font}, plot.references[i].label, {small_font, grey});
  }
}

void draw_legend(Canvas& canvas, const PlotLayout& layout) {
  if (layout.legend_box) canvas.rectangle(*layout.legend_box, white); // hides the grid lines
  for (const LegendEntry& entry : layout.legend) {
    const double y = entry.corner.y + legend_row / 2, x = entry.corner.x;
    const Series& series = *entry.curve->series;
    const Spot middle{x + legend_sample / 2, y};
    if (series.style != Style::dots)
      canvas.line({{x, y}, {x + legend_sample, y}}, entry.curve->pen);
    else if (series.marker == Marker::none)
      canvas.disc(middle, dot_radius, entry.curve->pen.color);
    draw_marker(canvas, series.marker, middle, entry.curve->pen.color);
    draw_lines(canvas, {x + legend_sample + gap, y + 0.36 * small_font}, entry.lines, {small_font});
  }
}

void draw(Canvas& canvas, const Plot& plot, const PlotLayout& layout) {
  draw_shaded(canvas, plot, layout.axes);
  draw_axes(canvas, layout);
  draw_references(canvas, plot, layout);
  draw_curves(canvas, layout.curves, layout.axes.area);
  draw_legend(canvas, layout);
}

} // namespace

Pen pen_of(const Series& series, std::size_t number) {
  Pen pen = series_pen(number);
  if (series.color) pen.color = *series.color;
  if (series.style == Style::solid && !series.color) return pen;
  pen.dashes = series.dashes;
  if (series.style == Style::dashed) pen.dashes = {7, 5};
  if (series.style == Style::dotted) pen.dashes = {0.1, 4};
  return pen;
}

std::string svg_text(const Plot& plot) {
  const PlotLayout layout = lay_out(plot);
  const auto canvas = make_svg_canvas(layout.width, layout.height);
  draw(*canvas, plot, layout);
  return canvas->encode();
}

void write_svg(const std::filesystem::path& path, const Plot& plot) { write_atomically(path, svg_text(plot)); }

void write_png(const std::filesystem::path& path, const Plot& plot) {
  const PlotLayout layout = lay_out(plot);
  RasterCanvas canvas(layout.width, layout.height, 2.5);
  draw(canvas, plot, layout);
  write_atomically(path, canvas.encode());
}

} // namespace riedel
