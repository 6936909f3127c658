/// The loose or weak patch of a biaxial specimen.
#pragma once

#include "core/base/parameters.hpp"
#include "core/base/types.hpp"

namespace riedel {

struct SpecimenPatch {
  Vec<2> centre, size; ///< [m]
  double void_ratio;   ///< [-]

  explicit SpecimenPatch(const Values& values);

  [[nodiscard]] bool is_empty() const { return size.prod() == 0.0; }
  /// Through the whole depth. Half open, so that a patch of whole cells takes that many rows of points wherever its
  /// edges fall.
  template <class Place>
  [[nodiscard]] bool contains(const Place& x) const {
    return within(0, x[0]) && within(1, x[1]);
  }
  /// Is there a point of the case's specimen in it?
  [[nodiscard]] bool holds_a_point(const Values& values) const;

private:
  [[nodiscard]] bool within(int axis, double x) const {
    constexpr double round_off = 1e-9;
    const double from = centre[axis] - 0.5 * size[axis] - round_off;
    return x >= from && x < from + size[axis];
  }
};

} // namespace riedel
