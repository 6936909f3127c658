#include "core/state/cell_order.hpp"

#include <algorithm>
#include <cmath>

namespace riedel {

namespace {
template <int Dim>
Counts<Dim> cell_of(const Grid<Dim>& grid, const Vec<Dim>& x) {
  Counts<Dim> cell{};
  for (int a = 0; a < Dim; ++a) {
    const double s = std::floor((x[a] - grid.origin[a]) / grid.cell[a]);
    cell[a] = std::isfinite(s) ? static_cast<Index>(std::clamp(s, 0.0, static_cast<double>(grid.nodes[a] - 1))) : 0;
  }
  return cell;
}
} // namespace

template <int Dim>
void sort_by_cell(const Grid<Dim>& grid, Index rows_per_slab, Points<Dim>& points, Slabs& slabs, SortSpace& space) {
  const Index slab_count = (grid.nodes[Dim - 1] + rows_per_slab - 1) / rows_per_slab;
  slabs.rows = rows_per_slab;
  slabs.begin.assign(static_cast<std::size_t>(slab_count) + 1, 0);
  space.keys.resize(static_cast<std::size_t>(points.size()));
  for (Index p = 0; p < points.size(); ++p) {
    const Counts<Dim> cell = cell_of(grid, points.position_of(p));
    const Index slab = cell[Dim - 1] / rows_per_slab;
    std::int64_t key = slab;
    for (int a = Dim - 2; a >= 0; --a) key = key * grid.nodes[a] + cell[a];
    key = key * rows_per_slab + cell[Dim - 1] % rows_per_slab;
    space.keys[static_cast<std::size_t>(p)] = {key, p};
    ++slabs.begin[static_cast<std::size_t>(slab) + 1];
  }
  for (std::size_t s = 1; s < slabs.begin.size(); ++s) slabs.begin[s] += slabs.begin[s - 1];

  std::sort(space.keys.begin(), space.keys.end());
  space.order.resize(space.keys.size());
  std::transform(space.keys.begin(), space.keys.end(), space.order.begin(), [](const auto& key) { return key.second; });
  for (Columns* field : points.fields()) field->reorder(space.order, space.column);
  space.ids.resize(space.order.size());
  for (std::size_t i = 0; i < space.order.size(); ++i)
    space.ids[i] = points.id[static_cast<std::size_t>(space.order[i])];
  points.id.swap(space.ids);
  for (Index p = 0; p < points.size(); ++p) points.place[static_cast<std::size_t>(points.id[p])] = p;
}

template void sort_by_cell<2>(const Grid<2>&, Index, Points<2>&, Slabs&, SortSpace&);
template void sort_by_cell<3>(const Grid<3>&, Index, Points<3>&, Slabs&, SortSpace&);

} // namespace riedel
