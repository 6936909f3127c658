#include "apps/biaxial/patch.hpp"

#include <cmath>

namespace riedel {

SpecimenPatch::SpecimenPatch(const Values& v)
    : centre(v.numbers("imperfection.centre")[0] * v.number("specimen.width"),
             v.numbers("imperfection.centre")[1] * v.number("specimen.height")),
      size(v.numbers("imperfection.size")[0], v.numbers("imperfection.size")[1]),
      void_ratio(v.number("imperfection.void_ratio")) {}

bool SpecimenPatch::holds_a_point(const Values& v) const {
  const Vec<2> edge(v.number("specimen.width"), v.number("specimen.height"));
  const auto holds = [&](int axis) {
    const double points = static_cast<double>(v.integers("grid.cells")[static_cast<std::size_t>(axis)]) *
                          v.number("specimen.points_per_cell");
    const double spacing = edge[axis] / points, first = std::floor((centre[axis] - 0.5 * size[axis]) / spacing - 0.5);
    for (double i = std::max(0.0, first); i < std::min(points, first + 3.0); ++i)
      if (within(axis, (i + 0.5) * spacing)) return true;
    return false;
  };
  return holds(0) && holds(1);
}

} // namespace riedel
