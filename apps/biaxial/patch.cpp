#include "apps/biaxial/patch.hpp"

#include <cmath>

namespace riedel {

VoidRatioField random_field(const BiaxialCase& values) {
  const BiaxialCase::Imperfection& field = values.imperfection;
  return {field.deviation, field.correlation_length, static_cast<std::uint64_t>(field.seed)};
}

SpecimenPatch::SpecimenPatch(const BiaxialCase& v)
    : centre(v.imperfection.centre[0] * v.specimen.width, v.imperfection.centre[1] * v.specimen.height),
      size(v.imperfection.size[0], v.imperfection.size[1]),
      void_ratio(v.imperfection.void_ratio) {}

bool SpecimenPatch::holds_a_point(const BiaxialCase& v) const {
  const Vec<2> edge(v.specimen.width, v.specimen.height);
  const auto holds = [&](int axis) {
    const double points = static_cast<double>(v.grid.cells[static_cast<std::size_t>(axis)]) *
                          static_cast<double>(v.specimen.points_per_cell);
    const double spacing = edge[axis] / points, first = std::floor((centre[axis] - 0.5 * size[axis]) / spacing - 0.5);
    for (double i = std::max(0.0, first); i < std::min(points, first + 3.0); ++i)
      if (within(axis, (i + 0.5) * spacing)) return true;
    return false;
  };
  return holds(0) && holds(1);
}

} // namespace riedel
