#include "core/io/domain_raster.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace riedel {
namespace {

/// The parallelogram nearest to a point's domain: centre and half edges, in cells of the raster.
struct Parallelogram {
  Spot centre, a, b;
  double determinant;

  /// 0 at the centre, 1 on the border.
  [[nodiscard]] double depth(Spot p) const {
    const double x = p.x - centre.x, y = p.y - centre.y;
    return std::max(std::abs(x * b.y - y * b.x), std::abs(y * a.x - x * a.y)) / std::abs(determinant);
  }
};

Parallelogram parallelogram(const double* corners, const Box& view, double cell) {
  const auto corner = [&](int i) {
    return Spot{(corners[3 * i] - view.left) / cell, (view.top - corners[3 * i + 1]) / cell};
  };
  const Spot p = corner(0), q = corner(1), r = corner(2), s = corner(3);
  Parallelogram domain{{(p.x + q.x + r.x + s.x) / 4, (p.y + q.y + r.y + s.y) / 4},
                       {(q.x + r.x - p.x - s.x) / 4, (q.y + r.y - p.y - s.y) / 4},
                       {(r.x + s.x - p.x - q.x) / 4, (r.y + s.y - p.y - q.y) / 4},
                       0};
  domain.determinant = domain.a.x * domain.b.y - domain.a.y * domain.b.x;
  return domain;
}

/// Raises (grow) or lowers each cell of every row to the greatest or least value within `reach` cells along the row.
void spread_along_rows(std::vector<char>& inside, int width, int height, int reach, bool grow) {
  std::vector<int> sum(static_cast<std::size_t>(width) + 1, 0);
  for (int y = 0; y < height; ++y) {
    char* row = inside.data() + std::ptrdiff_t{y} * width;
    for (int x = 0; x < width; ++x) sum[x + 1] = sum[x] + row[x];
    for (int x = 0; x < width; ++x) {
      const int from = std::max(0, x - reach), to = std::min(width, x + reach + 1), count = sum[to] - sum[from];
      row[x] = grow ? count > 0 : count == to - from;
    }
  }
}

std::vector<char> transposed(const std::vector<char>& cells, int width, int height) {
  std::vector<char> result(cells.size());
  for (std::size_t y = 0; y < static_cast<std::size_t>(height); ++y)
    for (std::size_t x = 0; x < static_cast<std::size_t>(width); ++x)
      result[x * static_cast<std::size_t>(height) + y] = cells[y * static_cast<std::size_t>(width) + x];
  return result;
}

/// Copies the common part of two grids of cells, the second shifted by so many columns and rows.
std::vector<char> shifted(const std::vector<char>& from, int width, int to_width, int to_height, int shift) {
  const int height = static_cast<int>(from.size()) / width;
  std::vector<char> to(static_cast<std::size_t>(to_width) * static_cast<std::size_t>(to_height), 0);
  for (int y = std::max(0, -shift); y < height && y + shift < to_height; ++y)
    for (int x = std::max(0, -shift); x < width && x + shift < to_width; ++x)
      to[static_cast<std::size_t>(y + shift) * static_cast<std::size_t>(to_width) +
         static_cast<std::size_t>(x + shift)] =
          from[static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x)];
  return to;
}

/// Closes gaps and notches into which no square of 2 reach + 1 cells fits.
void close_gaps(std::vector<char>& inside, int width, int height, int reach) {
  const int wide = width + 2 * reach, high = height + 2 * reach; // room to grow at the borders
  inside = shifted(inside, width, wide, high, reach);
  for (bool grow : {true, false}) {
    spread_along_rows(inside, wide, high, reach, grow);
    inside = transposed(inside, wide, high);
    spread_along_rows(inside, high, wide, reach, grow);
    inside = transposed(inside, high, wide);
  }
  inside = shifted(inside, wide, width, height, -reach);
}

} // namespace

/// Domains of deformed points overlap and gape. A cell belongs to the domain in which it lies deepest, measured in the
/// domain's own edges: domains that fit together show their true shape, others meet half way.
DomainRaster rasterise_domains(const Frame& frame, const Box& view, double cell) {
  DomainRaster raster{static_cast<int>(std::ceil((view.right - view.left) / cell)),
                      static_cast<int>(std::ceil((view.top - view.bottom) / cell)),
                      {}};
  const std::size_t cells = static_cast<std::size_t>(raster.width) * static_cast<std::size_t>(raster.height);
  raster.owner.assign(cells, -1);
  std::vector<float> depth(cells, std::numeric_limits<float>::max());
  std::vector<char> inside(cells, 0);
  double area = 0;

  constexpr double beyond = 3; // how far a domain may fill a gap beside it, in half edges
  for (std::size_t i = 0; i < frame.points(); ++i) {
    const Parallelogram domain = parallelogram(frame.corners.data() + 12 * i, view, cell);
    if (!(std::abs(domain.determinant) > 0)) continue;
    area += 4 * std::abs(domain.determinant);
    const double dx = beyond * (std::abs(domain.a.x) + std::abs(domain.b.x));
    const double dy = beyond * (std::abs(domain.a.y) + std::abs(domain.b.y));
    const auto within = [](double value, int size) { return static_cast<int>(std::clamp(value, 0.0, double(size))); };
    const int x1 = within(domain.centre.x + dx + 1, raster.width), y1 = within(domain.centre.y + dy + 1, raster.height);
    for (int y = within(domain.centre.y - dy, raster.height); y < y1; ++y)
      for (int x = within(domain.centre.x - dx, raster.width); x < x1; ++x) {
        const std::size_t at =
            static_cast<std::size_t>(y) * static_cast<std::size_t>(raster.width) + static_cast<std::size_t>(x);
        const auto here = static_cast<float>(domain.depth({x + 0.5, y + 0.5}));
        if (here <= 1) inside[at] = 1;
        if (here < depth[at] && here <= beyond) depth[at] = here, raster.owner[at] = static_cast<int>(i);
      }
  }

  const double side = std::sqrt(area / std::max<double>(1, static_cast<double>(frame.points())));
  close_gaps(inside, raster.width, raster.height, static_cast<int>(std::ceil(side)));
  for (std::size_t at = 0; at < cells; ++at)
    if (!inside[at]) raster.owner[at] = -1;
  return raster;
}

} // namespace riedel
