#include "core/analysis/depth_mean.hpp"

#include "core/base/error.hpp"

#include <algorithm>
#include <cmath>
#include <map>

namespace riedel {

namespace {

/// Columns by place in the plane; places that differ by less than half of `size` are the same column.
class Plane {
public:
  explicit Plane(double size) : size_(size) {}

  /// Number of the column at this place; adds one if there is none.
  std::size_t column(double x, double y) {
    const long i = std::lround(x / size_), j = std::lround(y / size_);
    for (const long a : {i, i - 1, i + 1})
      for (const long b : {j, j - 1, j + 1})
        if (const auto found = columns_.find({a, b});
            found != columns_.end() && std::hypot(found->second.x - x, found->second.y - y) < 0.5 * size_)
          return found->second.number;
    const std::size_t number = columns_.size();
    columns_[{i, j}] = {x, y, number};
    return number;
  }
  [[nodiscard]] std::size_t columns() const { return columns_.size(); }

private:
  struct Column {
    double x, y;
    std::size_t number;
  };
  double size_;
  std::map<std::pair<long, long>, Column> columns_;
};

/// Which points lay behind one another at the start.
struct Stacks {
  std::vector<std::size_t> of_point;
  std::vector<double> points; ///< in each column
};

Stacks stacks_of(const Frame& slab) {
  const std::vector<double>& u = slab.field("displacement").values;
  const std::vector<double>&V = slab.field("volume").values, &J = slab.field("volume_ratio").values;
  double minimum = V.front() / J.front();
  for (std::size_t p = 0; p < slab.points(); ++p) minimum = std::min(minimum, V[p] / J[p]);
  Plane plane(0.25 * std::cbrt(minimum)); // a quarter of the distance between points
  Stacks stacks;
  for (std::size_t p = 0; p < slab.points(); ++p)
    stacks.of_point.push_back(plane.column(slab.position[3 * p] - u[3 * p], slab.position[3 * p + 1] - u[3 * p + 1]));
  stacks.points.resize(plane.columns(), 0.0);
  for (const std::size_t column : stacks.of_point) stacks.points[column] += 1.0;
  return stacks;
}

/// @param of_each values per point
std::vector<double> mean(const std::vector<double>& values, const Stacks& stacks, std::size_t of_each) {
  std::vector<double> means(stacks.points.size() * of_each, 0.0);
  for (std::size_t i = 0; i < values.size(); ++i) {
    const std::size_t column = stacks.of_point[i / of_each];
    means[column * of_each + i % of_each] += values[i] / stacks.points[column];
  }
  return means;
}

/// Mean of the lower and upper faces of each hexahedron.
std::vector<double> middle_faces(const std::vector<double>& hexahedra) {
  constexpr std::size_t face = 4 * 3;
  std::vector<double> quads;
  for (std::size_t i = 0; i < hexahedra.size(); i += 2 * face)
    for (std::size_t k = i; k < i + face; ++k) quads.push_back(0.5 * (hexahedra[k] + hexahedra[k + face]));
  return quads;
}

void put_in_plane(std::vector<double>& xyz) {
  for (std::size_t i = 2; i < xyz.size(); i += 3) xyz[i] = 0.0;
}

} // namespace

Frame mean_over_depth(const Frame& all, double depth) {
  const Frame slab = deformable_points(all);
  const Stacks stacks = stacks_of(slab);
  Frame plane{.dimension = 2,
              .time = slab.time,
              .scalars = slab.scalars,
              .position = mean(slab.position, stacks, 3),
              .corners = mean(middle_faces(slab.corners), stacks, 4 * 3),
              .fields = {}};
  put_in_plane(plane.position);
  put_in_plane(plane.corners);
  for (const Field& field : slab.fields) {
    if (field.whole) continue;
    const auto of_each = static_cast<std::size_t>(field.components);
    plane.fields.push_back({field.name, field.components, field.unit, mean(field.values, stacks, of_each)});
    if (field.name != "volume" && field.name != "mass") continue;
    plane.fields.back().unit = field.name == "volume" ? "m2" : "kg/m";
    for (std::size_t c = 0; c < stacks.points.size(); ++c) plane.fields.back().values[c] *= stacks.points[c] / depth;
  }
  return plane;
}

double depth_of(const Frame& all) {
  const Frame slab = deformable_points(all);
  double low = slab.corners[2], high = low;
  for (std::size_t i = 2; i < slab.corners.size(); i += 3) {
    low = std::min(low, slab.corners[i]);
    high = std::max(high, slab.corners[i]);
  }
  return high - low;
}

} // namespace riedel
