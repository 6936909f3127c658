/// The bounding box of points, or of their displacements since some moment.
#pragma once

#include "core/base/columns.hpp"
#include "core/base/pack.hpp"
#include "core/base/parallel.hpp"

namespace riedel {

template <int Dim>
struct BoundingBox {
  Vec<Dim> lower, upper; ///< corners [m]; the upper one is infinite if any value is NaN
};

/// Of positions(a, p) − since(a, p), or of the positions alone if `since` is null; `boxes` is working space.
template <int Dim>
BoundingBox<Dim> bounding_box(const Columns& positions, const Columns* since, std::vector<BoundingBox<Dim>>& boxes) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  const auto of_block = [&](Range block) {
    BoundingBox<Dim> box;
    for (int a = 0; a < Dim; ++a) {
      const double *x = positions[a], *x_0 = since ? (*since)[a] : nullptr;
      Pack lower(infinity), upper(-infinity), wrong(0.0);
      const auto add = [&](const Pack& offset) {
        lower = min(lower, offset);
        upper = max(upper, offset);
        wrong += offset * Pack(0.0); // NaN if `offset` is not finite
      };
      Index p = block.begin;
      for (; p + pack_size <= block.end; p += pack_size)
        add(x_0 ? Pack::load(x + p) - Pack::load(x_0 + p) : Pack::load(x + p));
      for (; p < block.end; ++p) add(x_0 ? x[p] - x_0[p] : x[p]);
      std::array<double, pack_size> low, high;
      lower.store(low.data());
      upper.store(high.data());
      box.lower[a] = std::ranges::min(low);
      box.upper[a] = all(wrong <= Pack(0.0)) ? std::ranges::max(high) : infinity;
    }
    return box;
  };
  const auto both = [](const BoundingBox<Dim>& a, const BoundingBox<Dim>& b) {
    return BoundingBox<Dim>{a.lower.cwiseMin(b.lower), a.upper.cwiseMax(b.upper)};
  };
  const BoundingBox<Dim> nothing{Vec<Dim>::Constant(infinity), Vec<Dim>::Constant(-infinity)};
  return reduce_blocks(positions.size(), boxes, nothing, of_block, both);
}

} // namespace riedel
