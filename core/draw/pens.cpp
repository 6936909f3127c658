#include "core/draw/pens.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace riedel {

namespace {

/// Okabe and Ito (2008), without the yellow, which is too faint for a line on white; then wine, indigo and olive.
constexpr std::array<Color, 10> palette{{{0, 0.447, 0.698},
                                         {0.835, 0.369, 0},
                                         {0, 0.620, 0.451},
                                         {0.8, 0.475, 0.655},
                                         {0.902, 0.624, 0},
                                         {0.337, 0.706, 0.914},
                                         {0.2, 0.2, 0.2},
                                         {0.533, 0.133, 0.333},
                                         {0.200, 0.133, 0.533},
                                         {0.450, 0.450, 0.100}}};
constexpr double curve_width = 1.8;
constexpr std::size_t patterns = 8;

void outline(Canvas& canvas, Spot centre, Color color, const std::vector<Spot>& corners) {
  std::vector<Spot> line;
  for (const Spot& corner : corners) line.push_back({centre.x + corner.x, centre.y + corner.y});
  canvas.line(line, {color, 1.4, {}});
}

} // namespace

Color palette_color(std::size_t number) { return palette[number % palette.size()]; }

std::vector<double> dash_pattern(std::size_t number) {
  static const std::array<std::vector<double>, patterns> all{
      {{}, {6, 4}, {0.1, 3.5}, {9, 4, 0.1, 4}, {13, 4}, {2.5, 3.5}, {9, 4, 0.1, 4, 0.1, 4}, {8, 4, 2.5, 4}}};
  return all[number % patterns];
}

Pen series_pen(std::size_t number) {
  return {palette_color(number), curve_width, dash_pattern(number / palette.size())};
}

Pen pen_of_two(std::size_t color, std::size_t dashes) {
  const double pale = std::min(0.7, 0.45 * static_cast<double>(dashes / patterns));
  return {paler(palette_color(color), pale), curve_width, dash_pattern(dashes)};
}

Color paler(Color color, double part) {
  return {std::lerp(color.r, 1.0, part), std::lerp(color.g, 1.0, part), std::lerp(color.b, 1.0, part)};
}

Marker marker_of(std::size_t number) {
  constexpr std::array all{Marker::disc, Marker::square, Marker::diamond, Marker::triangle, Marker::cross};
  return all[number % all.size()];
}

void draw_marker(Canvas& canvas, Marker marker, Spot centre, Color color) {
  constexpr double r = 3.4;
  switch (marker) {
  case Marker::none:
    return;
  case Marker::disc:
    return canvas.disc(centre, 2.6, color);
  case Marker::square:
    return outline(canvas, centre, color, {{-r, -r}, {r, -r}, {r, r}, {-r, r}, {-r, -r}});
  case Marker::diamond:
    return outline(canvas, centre, color, {{0, -1.4 * r}, {1.4 * r, 0}, {0, 1.4 * r}, {-1.4 * r, 0}, {0, -1.4 * r}});
  case Marker::triangle:
    return outline(canvas, centre, color, {{0, -1.3 * r}, {1.2 * r, r}, {-1.2 * r, r}, {0, -1.3 * r}});
  case Marker::cross:
    outline(canvas, centre, color, {{-r, -r}, {r, r}});
    return outline(canvas, centre, color, {{-r, r}, {r, -r}});
  }
}

} // namespace riedel
