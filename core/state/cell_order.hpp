/// Points sorted by position, so that neighbours in space are neighbours in memory, and divided into slabs of cell rows
/// that two threads can process without touching the same node.
#pragma once

#include "core/state/grid.hpp"
#include "core/state/points.hpp"

namespace riedel {

/// Slab s contains the points begin[s] … begin[s + 1] − 1, which lie in `rows` rows of cells along the last axis when
/// sorted. Slabs of even number share no node, nor do those of odd number, as long as each keeps to its `node_rows`:
/// each set is distributed over threads, and every node receives its sums in the same order for any number of threads.
struct Slabs {
  Index rows = 0; ///< even
  std::vector<Index> begin;
  [[nodiscard]] Index count() const { return static_cast<Index>(begin.size()) - 1; }
  [[nodiscard]] Range range(Index s) const { return {begin[s], begin[s + 1]}; }
  /// Rows of nodes that the slab may touch: half a slab more on either side, up to the next slab of the same parity.
  [[nodiscard]] Range node_rows(Index s) const { return {s * rows - rows / 2 + 1, (s + 1) * rows + rows / 2 + 1}; }
};

/// Working space of a sort, kept so that repeated sorting allocates nothing.
struct SortSpace {
  std::vector<Index> cell; ///< of each point
  std::vector<Index> next; ///< position of the next point of each cell
  std::vector<Index> order, ids;
  AlignedVector<double> column;
  std::vector<Index> disorder; ///< per block
};

/// `space.cell` of points at their present positions; a cell has the number of its lowest node.
template <int Dim>
void find_cells(const Grid<Dim>& grid, const Points<Dim>& points, SortSpace& space);

/// Sorts by cell, cells numbered with the first axis fastest; points of one cell keep their order.
template <int Dim>
void sort_by_cell(const Grid<Dim>& grid, Index rows_per_slab, Points<Dim>& points, Slabs& slabs, SortSpace& space);

/// Number of points that lie in a cell before that of their predecessor.
template <int Dim>
Index out_of_order(const Grid<Dim>& grid, const Points<Dim>& points, SortSpace& space);

} // namespace riedel
