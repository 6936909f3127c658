#include "nonlocal/rows.hpp"

#include <cmath>

namespace riedel {

template <int Dim>
void require_finite(const Columns& positions) {
  for (Index p = 0; p < positions.size(); ++p)
    for (int a = 0; a < Dim; ++a)
      if (!std::isfinite(positions[a][p]))
        throw RunError("point " + std::to_string(p) + " has no finite position; its neighbours cannot be searched for");
}

template <int Dim>
void keep_neighbours(const Columns& positions, Index p, double radius, std::size_t first, std::vector<Index>& list) {
  const auto begin = list.begin() + static_cast<std::ptrdiff_t>(first);
  const double limit = square(radius);
  const auto far =
      std::remove_if(begin, list.end(), [&](Index q) { return squared_distance<Dim>(positions, p, q) > limit; });
  list.erase(far, list.end());
  std::sort(begin, list.end());
}

template void require_finite<2>(const Columns&);
template void require_finite<3>(const Columns&);
template void keep_neighbours<2>(const Columns&, Index, double, std::size_t, std::vector<Index>&);
template void keep_neighbours<3>(const Columns&, Index, double, std::size_t, std::vector<Index>&);

} // namespace riedel
