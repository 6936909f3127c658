/// Imperfections of the biaxial specimen: a loose or weak patch, a random field of void ratios.
#pragma once

#include "apps/biaxial/case.hpp"
#include "core/setup/random_field.hpp"

namespace riedel {

/// The random field of void ratios that a case asks for.
VoidRatioField random_field(const BiaxialCase& values);

struct SpecimenPatch {
  Vec<2> centre, size; ///< [m]
  double void_ratio;   ///< [-]

  explicit SpecimenPatch(const BiaxialCase& values);

  [[nodiscard]] bool is_empty() const { return size.prod() == 0.0; }
  /// Through the whole depth. Half open, so that a patch of whole cells takes that many rows of points wherever its
  /// edges fall.
  template <class Place>
  [[nodiscard]] bool contains(const Place& x) const {
    return within(0, x[0]) && within(1, x[1]);
  }
  /// Whether it contains a point of the case's specimen.
  [[nodiscard]] bool holds_a_point(const BiaxialCase& values) const;

private:
  [[nodiscard]] bool within(int axis, double x) const {
    constexpr double round_off = 1e-9;
    const double from = centre[axis] - 0.5 * size[axis] - round_off;
    return x >= from && x < from + size[axis];
  }
};

} // namespace riedel
