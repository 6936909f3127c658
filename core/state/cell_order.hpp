/// Points sorted by where they lie, so that neighbours in space are neighbours in memory, and cut into slabs of cell
/// rows that two threads can work on without touching one node twice.
#pragma once

#include "core/state/grid.hpp"
#include "core/state/points.hpp"

namespace riedel {

/// Slab s holds the points begin[s] … begin[s + 1] − 1, which lie in `rows` rows of cells along the last axis. With
/// slabs thick enough, those of even number touch no common node, nor do those of odd number: each set is spread over
/// threads and every node receives its sums in the same order whatever their number.
struct Slabs {
  Index rows = 0;
  std::vector<Index> begin;
  [[nodiscard]] Index count() const { return static_cast<Index>(begin.size()) - 1; }
  [[nodiscard]] Range range(Index s) const { return {begin[s], begin[s + 1]}; }
};

/// Working space of a sort, kept so that sorting again allocates nothing.
struct SortSpace {
  std::vector<std::pair<std::int64_t, Index>> keys;
  std::vector<Index> order, ids;
  AlignedVector<double> column;
};

/// Sorts by slab, then by column of cells, then by row; points of one cell keep their order.
template <int Dim>
void sort_by_cell(const Grid<Dim>& grid, Index rows_per_slab, Points<Dim>& points, Slabs& slabs, SortSpace& space);

} // namespace riedel
