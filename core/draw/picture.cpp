#include "core/draw/picture.hpp"

#include "core/base/error.hpp"
#include "core/draw/field_image.hpp"
#include "core/draw/text_lines.hpp"
#include "core/io/atomic_file.hpp"

#include <algorithm>
#include <cmath>

namespace riedel {
namespace {

constexpr Color grey{0.45, 0.45, 0.45};
constexpr double millimetre = 1e-3; ///< [m]
constexpr int bar_ticks = 6;
constexpr double title_size = 1.1, subtitle_size = 0.9, heading_size = 1.25; ///< relative to the font's
constexpr std::size_t max_lines = 3;

void check(const std::vector<Panel>& panels, const PictureOptions& options) {
  if (panels.empty()) throw std::logic_error("a picture without panels");
  for (const Panel& panel : panels) {
    panel.frame->check();
    if (panel.frame->dimension != 2 || panel.frame->corners.empty())
      throw InputError("pictures show the domains of points in two dimensions; for others open the .pvd in ParaView");
    if (const Field& field = panel.frame->field(options.field);
        options.component < 0 || options.component >= field.components)
      throw InputError("field '" + field.name + "' has no component " + std::to_string(options.component));
  }
}

Interval color_range(const std::vector<Panel>& panels, const PictureOptions& options) {
  Extent extent;
  for (const Panel& panel : panels) {
    for (const double value : FieldColors{options.field, options.component, {}, options.unit}.values(*panel.frame))
      extent.add(value);
  }
  return options.range.value_or(extent.interval(0));
}

Box common_view(const std::vector<Panel>& panels) {
  std::vector<const Frame*> frames;
  for (const Panel& panel : panels) frames.push_back(panel.frame);
  return view_of(frames);
}

struct Layout {
  Box view;        ///< in metres, top > bottom
  Interval colors; ///< of the field
  double font;     ///< [px], like all that follows
  double scale;    ///< pixels per metre
  double width, height;
  std::vector<std::string> heading;
  std::vector<std::vector<std::string>> titles, subtitles; ///< lines of each panel
  std::size_t title_lines, subtitle_lines;                 ///< the largest number in any panel
  std::vector<Box> areas;                                  ///< one for each panel, on whole pixels
  Box bar;
  std::vector<double> bar_values;
  std::vector<std::string> bar_labels;
};

Interval millimetres(double low, double high) { return {low / millimetre, high / millimetre}; }

/// Splits titles into lines of at most that width. @return width of the widest
double wrap_titles(Layout& l, const std::vector<Panel>& panels, const PictureOptions& options, double width) {
  l.heading = lines_of(options.title, heading_size * l.font, options.width - 3 * l.font, max_lines);
  double maximum = 0;
  l.title_lines = l.subtitle_lines = 0;
  for (const Panel& panel : panels) {
    l.titles.push_back(lines_of(panel.title, title_size * l.font, width, max_lines));
    l.subtitles.push_back(lines_of(panel.subtitle, subtitle_size * l.font, width, max_lines));
    l.title_lines = std::max(l.title_lines, l.titles.back().size());
    l.subtitle_lines = std::max(l.subtitle_lines, l.subtitles.back().size());
    maximum = std::max(
        {maximum, widest(l.titles.back(), title_size * l.font), widest(l.subtitles.back(), subtitle_size * l.font)});
  }
  return maximum;
}

/// Height of everything above the panels, in font sizes.
double heading_rows(const Layout& l) {
  const auto rows = [](std::size_t lines, double first, double next) {
    return lines == 0 ? 0 : first + next * static_cast<double>(lines - 1);
  };
  return 0.8 + rows(l.heading.size(), 2.4, 1.5) + rows(l.title_lines, 1.7, 1.3) + rows(l.subtitle_lines, 1.4, 1.1);
}

Layout lay_out(const std::vector<Panel>& panels, const PictureOptions& options) {
  Layout l;
  l.view = common_view(panels);
  l.colors = color_range(panels, options);
  l.font = std::max(10.0, std::round(std::min(options.width, options.height) / 46.0));
  l.bar_values = round_ticks(l.colors, bar_ticks);
  l.bar_labels = tick_labels(l.bar_values);

  const double count = static_cast<double>(panels.size());
  const double across = l.view.right - l.view.left, up = l.view.top - l.view.bottom;
  const double y_labels = widest(tick_labels(round_ticks(millimetres(l.view.bottom, l.view.top), 8)), l.font);
  const double left = 3.2 * l.font + y_labels, bottom = 4 * l.font, space = 1.5 * l.font;
  const double right = 6 * l.font + widest(l.bar_labels, l.font);
  const double room = std::max(options.width - left - right - (count - 1) * space, count * 4 * l.font);
  const double widest_panel = std::min(room / count, across / up * options.height);
  const double titles = wrap_titles(l, panels, options, std::max(widest_panel + (count > 1 ? 0 : right), 12 * l.font));

  const double top = std::round(heading_rows(l) * l.font);
  l.scale = std::min(room / (count * across), std::max(options.height - top - bottom, 4 * l.font) / up);
  const double panel_width = std::floor(across * l.scale + 1e-6), panel_height = std::floor(up * l.scale + 1e-6);
  const double column = std::max(panel_width, titles + (count > 1 ? space : 0));
  const double beside = 0.5 * (column - panel_width); // excess of a title over its panel's width
  const double content =
      std::max(left, beside) + (count - 1) * (column + space) + panel_width + std::max(right, beside);
  l.width = std::max(content, widest(l.heading, heading_size * l.font) + 2 * space);
  l.height = top + panel_height + bottom;
  double x = std::round((l.width - content) / 2 + std::max(left, beside));
  for (std::size_t i = 0; i < panels.size(); ++i, x += std::round(column + space))
    l.areas.push_back({x, top, x + panel_width, top + panel_height});
  const Box& last = l.areas.back();
  const double shorter = 0.1 * panel_height;
  l.bar = {last.right + 1.4 * l.font, last.top + shorter, last.right + 2.4 * l.font, last.bottom - shorter};
  return l;
}

/// @param first whether to label the vertical axis, which the panels share
void draw_axes(RasterCanvas& canvas, const Layout& l, const Box& area, bool first) {
  const double f = l.font, tick = 0.35 * f;
  const Pen axis{ink, std::max(1.0, std::round(f / 14))};
  canvas.line({{area.left, area.top},
               {area.right, area.top},
               {area.right, area.bottom},
               {area.left, area.bottom},
               {area.left, area.top}},
              axis);
  const Interval across = millimetres(l.view.left, l.view.right), up = millimetres(l.view.bottom, l.view.top);
  const auto x_ticks = round_ticks(across, std::max(2, static_cast<int>(area.width() / (5 * f))));
  const auto y_ticks = round_ticks(up, std::max(2, static_cast<int>(area.height() / (5 * f))));
  const auto x_labels = tick_labels(x_ticks), y_labels = tick_labels(y_ticks);
  for (std::size_t i = 0; i < x_ticks.size(); ++i) {
    const double x = area.left + across.part(x_ticks[i]) * area.width();
    canvas.line({{x, area.bottom}, {x, area.bottom + tick}}, axis);
    canvas.text({x, area.bottom + tick + 1.15 * f}, x_labels[i], {f, ink, Anchor::middle});
  }
  for (std::size_t i = 0; i < y_ticks.size(); ++i) {
    const double y = area.bottom - up.part(y_ticks[i]) * area.height();
    canvas.line({{area.left - tick, y}, {area.left, y}}, axis);
    if (first) canvas.text({area.left - tick - 0.3 * f, y + 0.36 * f}, y_labels[i], {f, ink, Anchor::end});
  }
  canvas.text({(area.left + area.right) / 2, area.bottom + 3.1 * f}, "x [mm]", {f, ink, Anchor::middle});
  if (!first) return;
  const double x = area.left - tick - 1.1 * f - widest(y_labels, f);
  canvas.text({x, (area.top + area.bottom) / 2}, "y [mm]", {f, ink, Anchor::middle, true});
}

void draw_color_bar(RasterCanvas& canvas, const Layout& l, const std::string& label) {
  const double f = l.font;
  const int top = static_cast<int>(l.bar.top), bottom = static_cast<int>(l.bar.bottom);
  for (int y = top; y < bottom; ++y)
    for (int x = static_cast<int>(l.bar.left); x < static_cast<int>(l.bar.right); ++x)
      canvas.blend(x, y, viridis((bottom - y - 0.5) / (bottom - top)), 1);
  for (std::size_t i = 0; i < l.bar_values.size(); ++i) {
    const double y = bottom - l.colors.part(l.bar_values[i]) * (bottom - top);
    canvas.line({{l.bar.right, y}, {l.bar.right + 0.3 * f, y}}, {ink, std::max(1.0, std::round(f / 14))});
    canvas.text({l.bar.right + 0.6 * f, y + 0.36 * f}, l.bar_labels[i], {f});
  }
  const double x = l.bar.right + 2.1 * f + widest(l.bar_labels, f);
  const auto lines = lines_of(label, f, l.areas.back().height() + 3 * f, 2);
  for (std::size_t i = 0; i < lines.size(); ++i)
    canvas.text({x + 1.3 * f * static_cast<double>(i), (l.bar.top + l.bar.bottom) / 2}, lines[i],
                {f, ink, Anchor::middle, true});
}

/// Lines of text stacked upwards. @param at base line of the last
void draw_upwards(RasterCanvas& canvas, Spot at, double step, const std::vector<std::string>& lines,
                  const Lettering& lettering) {
  for (std::size_t i = 0; i < lines.size(); ++i)
    canvas.text({at.x, at.y - step * static_cast<double>(lines.size() - 1 - i)}, lines[i], lettering);
}

void draw_titles(RasterCanvas& canvas, const Layout& l) {
  for (std::size_t i = 0; i < l.areas.size(); ++i) {
    const double x = (l.areas[i].left + l.areas[i].right) / 2, y = l.areas[i].top - 0.7 * l.font;
    draw_upwards(canvas, {x, y}, 1.1 * l.font, l.subtitles[i], {subtitle_size * l.font, grey, Anchor::middle});
    const double above = l.subtitle_lines == 0 ? 0 : 1.4 + 1.1 * static_cast<double>(l.subtitle_lines - 1);
    draw_upwards(canvas, {x, y - above * l.font}, 1.3 * l.font, l.titles[i],
                 {title_size * l.font, ink, Anchor::middle});
  }
  const double lines = static_cast<double>(std::max<std::size_t>(l.heading.size(), 1) - 1);
  draw_upwards(canvas, {l.width / 2, (2.1 + 1.5 * lines) * l.font}, 1.5 * l.font, l.heading,
               {heading_size * l.font, ink, Anchor::middle});
}

} // namespace

void write_field_picture(const std::filesystem::path& path, const Frame& frame, const PictureOptions& options) {
  PictureOptions rest = options;
  rest.title.clear();
  write_field_pictures(path, {{&frame, options.title, options.subtitle}}, rest);
}

void write_field_pictures(const std::filesystem::path& path, const std::vector<Panel>& panels,
                          const PictureOptions& options) {
  check(panels, options);
  const Layout l = lay_out(panels, options);
  RasterCanvas canvas(l.width, l.height);
  for (std::size_t i = 0; i < panels.size(); ++i) {
    paint_field(canvas, *panels[i].frame, {options.field, options.component, l.colors, options.unit}, l.view,
                l.areas[i], l.scale);
    draw_axes(canvas, l, l.areas[i], i == 0);
  }
  draw_titles(canvas, l);
  draw_color_bar(canvas, l, options.label);
  write_atomically(path, canvas.encode());
}

} // namespace riedel
