#include "core/draw/field_image.hpp"

#include "core/draw/domain_raster.hpp"

#include <cmath>

namespace riedel {
namespace {
constexpr Color unknown{0.75, 0.75, 0.75};

/// A scale bar with end marks, and its length below.
void draw_length_bar(RasterCanvas& canvas, const Box& area, double length, double scale, double font) {
  const double bar = length * scale, width = text_width(length_text(length), font);
  const double left = area.left + 0.5 * (area.width() - bar), y = area.top + 0.5 * font, end = 0.3 * font;
  const Pen pen{ink, std::max(1.5, font / 9), {}};
  canvas.line({{left, y}, {left + bar, y}}, pen);
  for (const double x : {left, left + bar}) canvas.line({{x, y - end}, {x, y + end}}, pen);
  canvas.text({area.left + 0.5 * (area.width() - width), y + 1.5 * font}, length_text(length), {font});
}
} // namespace

std::vector<double> FieldColors::values(const Frame& frame) const {
  const Field& of = frame.field(field);
  const auto step = static_cast<std::size_t>(of.components), first = static_cast<std::size_t>(component);
  std::vector<double> numbers;
  for (std::size_t i = first; i < of.values.size(); i += step) numbers.push_back(unit * of.values[i]);
  return numbers;
}

Box view_of(const std::vector<const Frame*>& frames) {
  Extent x, y;
  for (const Frame* frame : frames)
    for (std::size_t i = 0; i < frame->corners.size(); i += 3) {
      x.add(frame->corners[i]);
      y.add(frame->corners[i + 1]);
    }
  const Interval across = x.interval(0), up = y.interval(0);
  const double margin = 0.03 * std::max(across.width(), up.width());
  return {across.low - margin, up.high + margin, across.high + margin, up.low - margin};
}

void paint_field(RasterCanvas& canvas, const Frame& frame, const FieldColors& colors, const Box& view, const Box& area,
                 double scale) {
  constexpr int fine = 3; // samples along each edge of a pixel
  const DomainRaster raster = rasterise_domains(frame, view, 1 / (scale * fine));
  std::vector<Color> color_of;
  for (const double value : colors.values(frame))
    color_of.push_back(std::isfinite(value) ? viridis(colors.range.part(value)) : unknown);
  for (int y = 0; y < raster.height / fine; ++y)
    for (int x = 0; x < raster.width / fine; ++x) {
      Color sum;
      int covered = 0;
      for (int sample = 0; sample < fine * fine; ++sample) {
        const int point = raster.at(fine * x + sample % fine, fine * y + sample / fine);
        if (point < 0) continue;
        const Color& color = color_of[static_cast<std::size_t>(point)];
        sum = {sum.r + color.r, sum.g + color.g, sum.b + color.b};
        ++covered;
      }
      if (covered == 0) continue;
      canvas.blend(static_cast<int>(area.left) + x, static_cast<int>(area.top) + y,
                   {sum.r / covered, sum.g / covered, sum.b / covered}, double(covered) / (fine * fine));
    }
}

double round_length(double maximum) {
  const double power = std::pow(10.0, std::floor(std::log10(maximum) + 1e-9));
  for (const double factor : {5.0, 2.0})
    if (factor * power <= maximum * (1.0 + 1e-9)) return factor * power;
  return power;
}

std::string length_text(double length) {
  if (length >= 1.0) return plain_number(length) + " m";
  return length >= 1e-3 ? plain_number(1e3 * length) + " mm" : plain_number(1e6 * length) + " µm";
}

std::string field_image(const Frame& frame, const FieldColors& colors, const Box& view, int height) {
  const double scale = height / (view.top - view.bottom);
  const Box area{0.0, 0.0, std::ceil((view.right - view.left) * scale), static_cast<double>(height)};
  const double font = std::max(9.0, std::round(height / 28.0));
  RasterCanvas canvas(area.width(), area.height() + std::ceil(2.5 * font));
  paint_field(canvas, frame, colors, view, area, scale);
  draw_length_bar(canvas, {area.left, area.bottom, area.right, area.bottom}, round_length(0.6 * area.width() / scale),
                  scale, font);
  return canvas.encode();
}

} // namespace riedel
