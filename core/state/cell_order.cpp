#include "core/state/cell_order.hpp"

#include "core/base/parallel.hpp"

#include <algorithm>
#include <cmath>

namespace riedel {

namespace {

/// Number of the cell at x; positions off the grid belong to the nearest cell.
template <int Dim>
Index cell_at(const Grid<Dim>& grid, const Columns& position, Index p) {
  Index cell = 0;
  for (int a = Dim - 1; a >= 0; --a) {
    const double s = std::floor((position[a][p] - grid.origin[a]) / grid.cell[a]), last = grid.nodes[a] - 1;
    cell = cell * grid.nodes[a] + static_cast<Index>(s >= 0.0 ? std::min(s, last) : 0.0); // 0 for NaN
  }
  return cell;
}

} // namespace

template <int Dim>
void find_cells(const Grid<Dim>& grid, const Points<Dim>& points, SortSpace& space) {
  space.cell.resize(static_cast<std::size_t>(points.size()));
  for_each_block(points.size(), [&](Range block) {
    for (Index p = block.begin; p < block.end; ++p) space.cell[p] = cell_at(grid, points.position, p);
  });
}

template <int Dim>
void sort_by_cell(const Grid<Dim>& grid, Index rows_per_slab, Points<Dim>& points, Slabs& slabs, SortSpace& space) {
  find_cells(grid, points, space);
  space.next.assign(static_cast<std::size_t>(grid.node_count()) + 1, 0);
  for (const Index cell : space.cell) ++space.next[cell + 1];
  std::partial_sum(space.next.begin(), space.next.end(), space.next.begin());

  slabs.rows = rows_per_slab;
  const Index slab_count = (grid.nodes[Dim - 1] + rows_per_slab - 1) / rows_per_slab;
  const Index cells_of_slab = grid.strides()[Dim - 1] * rows_per_slab;
  slabs.begin.resize(static_cast<std::size_t>(slab_count) + 1);
  for (Index s = 0; s < slab_count; ++s) slabs.begin[s] = space.next[s * cells_of_slab];
  slabs.begin[slab_count] = points.size();

  space.order.resize(space.cell.size());
  for (Index p = 0; p < points.size(); ++p) space.order[space.next[space.cell[p]]++] = p;
  for (Columns* field : points.fields()) field->reorder(space.order, space.column);
  space.ids.resize(space.order.size());
  parallel_for(points.size(), [&](Index p) { space.ids[p] = points.id[space.order[p]]; });
  points.id.swap(space.ids);
  parallel_for(points.size(), [&](Index p) { points.place[points.id[p]] = p; });
}

template <int Dim>
Index out_of_order(const Grid<Dim>& grid, const Points<Dim>& points, SortSpace& space) {
  find_cells(grid, points, space);
  const auto of_block = [&](Range block) {
    Index count = 0;
    for (Index p = std::max(block.begin, 1); p < block.end; ++p) count += space.cell[p] < space.cell[p - 1];
    return count;
  };
  return reduce_blocks(points.size(), space.disorder, 0, of_block, std::plus<>());
}

template void find_cells<2>(const Grid<2>&, const Points<2>&, SortSpace&);
template void find_cells<3>(const Grid<3>&, const Points<3>&, SortSpace&);
template void sort_by_cell<2>(const Grid<2>&, Index, Points<2>&, Slabs&, SortSpace&);
template void sort_by_cell<3>(const Grid<3>&, Index, Points<3>&, Slabs&, SortSpace&);
template Index out_of_order<2>(const Grid<2>&, const Points<2>&, SortSpace&);
template Index out_of_order<3>(const Grid<3>&, const Points<3>&, SortSpace&);

} // namespace riedel
