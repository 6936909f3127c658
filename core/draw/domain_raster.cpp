#include "core/draw/domain_raster.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace riedel {
namespace {

/// Best-fit parallelogram of a point's domain: centre and half edges, in cells of the raster.
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

/// Replaces each cell by the maximum (grow) or minimum within `reach` cells along its row.
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
  for (std::ptrdiff_t y = 0; y < height; ++y)
    for (std::ptrdiff_t x = 0; x < width; ++x)
      result[static_cast<std::size_t>(x * height + y)] = cells[static_cast<std::size_t>(y * width + x)];
  return result;
}

/// Copies the common part of two grids of cells, the second shifted by `shift` columns and rows.
std::vector<char> shifted(const std::vector<char>& from, int width, int to_width, int to_height, int shift) {
  const int height = static_cast<int>(from.size()) / width;
  std::vector<char> to(static_cast<std::size_t>(to_width) * static_cast<std::size_t>(to_height), 0);
  for (std::ptrdiff_t y = std::max(0, -shift); y < height && y + shift < to_height; ++y)
    for (int x = std::max(0, -shift); x < width && x + shift < to_width; ++x)
      to[static_cast<std::size_t>((y + shift) * to_width + x + shift)] = from[static_cast<std::size_t>(y * width + x)];
  return to;
}

/// Closes gaps and notches too narrow for a square of 2 reach + 1 cells.
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

constexpr double beyond = 3; ///< how far a domain may extend into a gap, in half edges

/// A raster under construction.
struct Painting {
  DomainRaster raster;
  std::vector<float> depth; ///< of each cell in its present owner's domain
  std::vector<char> inside; ///< whether any domain covers the cell

  /// Assigns to the point every cell that lies deeper in its domain than in those before it.
  void add(int point, const Parallelogram& domain) {
    const auto within = [](double value, int size) { return static_cast<int>(std::clamp(value, 0.0, double(size))); };
    const double dx = beyond * (std::abs(domain.a.x) + std::abs(domain.b.x));
    const double dy = beyond * (std::abs(domain.a.y) + std::abs(domain.b.y));
    const int x0 = within(domain.centre.x - dx, raster.width), x1 = within(domain.centre.x + dx + 1, raster.width);
    const int y0 = within(domain.centre.y - dy, raster.height), y1 = within(domain.centre.y + dy + 1, raster.height);
    for (int y = y0; y < y1; ++y)
      for (int x = x0; x < x1; ++x) {
        const auto at = static_cast<std::size_t>(std::ptrdiff_t{y} * raster.width + x);
        const auto here = static_cast<float>(domain.depth({x + 0.5, y + 0.5}));
        if (here <= 1) inside[at] = 1;
        if (here > beyond || here >= depth[at]) continue;
        depth[at] = here;
        raster.owner[at] = point;
      }
  }
};

} // namespace

/// Domains of deformed points overlap and leave gaps. A cell belongs to the domain in which it lies deepest, relative
/// to the domain's edges: domains that fit together keep their true shape, others meet half way.
DomainRaster rasterise_domains(const Frame& frame, const Box& view, double cell) {
  const int width = static_cast<int>(std::ceil((view.right - view.left) / cell - 1e-6));
  const int height = static_cast<int>(std::ceil((view.top - view.bottom) / cell - 1e-6));
  const std::size_t cells = static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
  Painting painting{{width, height, std::vector<int>(cells, -1)},
                    std::vector<float>(cells, std::numeric_limits<float>::max()),
                    std::vector<char>(cells, 0)};
  double area = 0;
  for (std::size_t i = 0; i < frame.points(); ++i) {
    const Parallelogram domain = parallelogram(frame.corners.data() + 12 * i, view, cell);
    if (!(std::abs(domain.determinant) > 0)) continue; // flat, or not a number
    painting.add(static_cast<int>(i), domain);
    area += 4 * std::abs(domain.determinant);
  }

  const double side = std::sqrt(area / std::max(1.0, static_cast<double>(frame.points())));
  const int reach = static_cast<int>(std::min(std::ceil(side), std::max(width, height) / 4.0));
  close_gaps(painting.inside, width, height, reach);
  for (std::size_t at = 0; at < cells; ++at)
    if (!painting.inside[at]) painting.raster.owner[at] = -1;
  return std::move(painting.raster);
}

} // namespace riedel
