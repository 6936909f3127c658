#include "core/draw/raster_canvas.hpp"

#include <algorithm>
#include <cmath>

namespace riedel {
namespace {

double distance(Spot p, Spot a, Spot b) {
  const double dx = b.x - a.x, dy = b.y - a.y, length2 = dx * dx + dy * dy;
  const double along = length2 > 0 ? std::clamp(((p.x - a.x) * dx + (p.y - a.y) * dy) / length2, 0.0, 1.0) : 0.0;
  return std::hypot(p.x - a.x - along * dx, p.y - a.y - along * dy);
}

/// Part of the pixel [i, i + 1] that lies in [low, high].
double overlap(int i, double low, double high) {
  return std::clamp(std::min(i + 1.0, high) - std::max(double(i), low), 0.0, 1.0);
}

/// The drawn pieces of a dashed line.
std::vector<std::vector<Spot>> dashes_of(const std::vector<Spot>& spots, const std::vector<double>& lengths) {
  std::vector<std::vector<Spot>> pieces(1, {spots.front()});
  std::size_t dash = 0;
  double left = lengths[0];
  for (std::size_t i = 1; i < spots.size(); ++i) {
    Spot at = spots[i - 1];
    double rest = std::hypot(spots[i].x - at.x, spots[i].y - at.y);
    while (rest > left) {
      at = {at.x + (spots[i].x - at.x) * left / rest, at.y + (spots[i].y - at.y) * left / rest};
      rest -= left;
      if (dash++ % 2 == 0) {
        pieces.back().push_back(at);
      } else {
        pieces.push_back({at});
      }
      left = lengths[dash % lengths.size()];
    }
    left -= rest;
    if (dash % 2 == 0) pieces.back().push_back(spots[i]);
  }
  return pieces;
}

} // namespace

RasterCanvas::RasterCanvas(double width, double height, double scale)
    : width_(static_cast<int>(std::lround(width * scale))),
      height_(static_cast<int>(std::lround(height * scale))),
      scale_(scale),
      pixels_(static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_), white) {}

void RasterCanvas::blend(int x, int y, Color color, double cover) {
  if (x < 0 || y < 0 || x >= width_ || y >= height_) return;
  Color& pixel = pixels_[static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) + static_cast<std::size_t>(x)];
  pixel = {std::lerp(pixel.r, color.r, cover), std::lerp(pixel.g, color.g, cover), std::lerp(pixel.b, color.b, cover)};
}

void RasterCanvas::line(const std::vector<Spot>& spots, const Pen& pen) {
  if (spots.empty()) return;
  std::vector<Spot> scaled;
  for (const Spot& spot : spots) scaled.push_back({spot.x * scale_, spot.y * scale_});
  const double half_width = pen.width * scale_ / 2;
  if (pen.dashes.empty()) return stroke(scaled, half_width, pen.color);
  std::vector<double> lengths;
  for (double dash : pen.dashes) lengths.push_back(dash * scale_);
  for (const auto& piece : dashes_of(scaled, lengths)) stroke(piece, half_width, pen.color);
}

/// A pixel is covered according to its distance from the nearest segment, within half a width. The largest coverage
/// over all segments counts, so that joints are no darker than the rest.
void RasterCanvas::stroke(const std::vector<Spot>& spots, double half_width, Color color) {
  const double reach = half_width + 0.5;
  double left = spots[0].x, right = left, top = spots[0].y, bottom = top;
  for (const Spot& s : spots) {
    left = std::min(left, s.x), right = std::max(right, s.x);
    top = std::min(top, s.y), bottom = std::max(bottom, s.y);
  }
  const auto within = [](double value, int size) { return static_cast<int>(std::clamp(value, 0.0, double(size))); };
  const int x0 = within(left - reach, width_), x1 = within(right + reach + 1, width_);
  const int y0 = within(top - reach, height_), y1 = within(bottom + reach + 1, height_);
  const auto index = [&](int x, int y) { return static_cast<std::size_t>((y - y0) * (x1 - x0) + x - x0); };

  std::vector<float> cover(static_cast<std::size_t>((x1 - x0) * (y1 - y0)), 0.0F);
  for (std::size_t i = 0; i < spots.size(); ++i) {
    const Spot a = spots[i > 0 ? i - 1 : 0], b = spots[i];
    for (int y = std::max(y0, static_cast<int>(std::min(a.y, b.y) - reach)); y < y1 && y < std::max(a.y, b.y) + reach;
         ++y)
      for (int x = std::max(x0, static_cast<int>(std::min(a.x, b.x) - reach)); x < x1 && x < std::max(a.x, b.x) + reach;
           ++x) {
        const double inside =
            std::clamp(reach - distance({x + 0.5, y + 0.5}, a, b), 0.0, std::min(1.0, 2 * half_width));
        cover[index(x, y)] = std::max(cover[index(x, y)], static_cast<float>(inside));
      }
  }
  for (int y = y0; y < y1; ++y)
    for (int x = x0; x < x1; ++x) blend(x, y, color, cover[index(x, y)]);
}

void RasterCanvas::disc(Spot centre, double radius, Color color) {
  stroke({{centre.x * scale_, centre.y * scale_}}, radius * scale_, color);
}

void RasterCanvas::rectangle(const Box& box, Color color) {
  const double left = box.left * scale_, right = box.right * scale_;
  const double top = box.top * scale_, bottom = box.bottom * scale_;
  for (int y = static_cast<int>(std::floor(top)); y < bottom; ++y)
    for (int x = static_cast<int>(std::floor(left)); x < right; ++x)
      blend(x, y, color, overlap(x, left, right) * overlap(y, top, bottom));
}

void RasterCanvas::text(Spot at, const std::string& text, const Lettering& lettering) {
  const TextMask mask = text_mask(text, lettering.size * scale_);
  const double before = lettering.anchor == Anchor::start ? 0.0 : lettering.anchor == Anchor::middle ? 0.5 : 1.0;
  const int start = static_cast<int>(std::lround(-before * mask.width));
  const int x0 = static_cast<int>(std::lround(at.x * scale_)), y0 = static_cast<int>(std::lround(at.y * scale_));
  auto cover = mask.cover.begin();
  for (int row = 0; row < mask.height; ++row)
    for (int column = 0; column < mask.width; ++column) {
      const int along = start + column, down = row - mask.baseline;
      const int x = lettering.upright ? x0 + down : x0 + along, y = lettering.upright ? y0 - along : y0 + down;
      blend(x, y, lettering.color, *cover++ / 255.0);
    }
}

std::string RasterCanvas::encode() const {
  std::vector<unsigned char> rgb;
  rgb.reserve(3 * pixels_.size());
  for (const Color& pixel : pixels_)
    for (double part : {pixel.r, pixel.g, pixel.b}) rgb.push_back(static_cast<unsigned char>(std::lround(255 * part)));
  return encode_png(width_, height_, rgb);
}

} // namespace riedel
