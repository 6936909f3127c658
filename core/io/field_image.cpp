#include "core/io/field_image.hpp"

#include "core/io/domain_raster.hpp"

#include <cmath>

namespace riedel {
namespace {
constexpr Color unknown{0.75, 0.75, 0.75};
} // namespace

std::vector<double> FieldColors::values(const Frame& frame) const {
  const Field& of = frame.field(field);
  const auto step = static_cast<std::size_t>(of.components), first = static_cast<std::size_t>(component);
  std::vector<double> numbers;
  for (std::size_t i = first; i < of.values.size(); i += step) numbers.push_back(of.values[i]);
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

std::string field_image(const Frame& frame, const FieldColors& colors, const Box& view, int height) {
  const double scale = height / (view.top - view.bottom);
  const Box area{0.0, 0.0, std::ceil((view.right - view.left) * scale), static_cast<double>(height)};
  RasterCanvas canvas(area.width(), area.height());
  paint_field(canvas, frame, colors, view, area, scale);
  return canvas.encode();
}

} // namespace riedel
