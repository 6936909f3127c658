/// Neighbours by bins: points are sorted into square cells half a radius wide; those around a point are searched.
#pragma once

#include "core/interface/neighbour_search.hpp"

namespace riedel {

/// Cells are hashed into about as many bins as there are points, so that memory does not grow with their distances.
template <int Dim>
class CellList final : public NeighbourSearch<Dim> {
public:
  void find(const Columns& positions, double radius, NeighbourRows& rows) override;

private:
  using Cell = std::array<std::int64_t, Dim>;

  void sort_into_bins(const Columns& positions);
  [[nodiscard]] Cell cell_at(const Vec<Dim>& place) const;
  [[nodiscard]] std::size_t bin_of(const Cell& cell) const;
  void append_cells(const Cell& lower, const Cell& upper, std::vector<Index>& list) const;

  double side_ = 0.0;              ///< of a cell [m]
  Vec<Dim> origin_;                ///< corner of cell (0, 0[, 0]) [m]
  std::size_t last_bin_ = 0;       ///< number of bins minus one; the number is a power of two
  std::vector<std::size_t> first_; ///< of each bin, in `sorted_`
  std::vector<std::size_t> bins_;  ///< of each point
  std::vector<Index> sorted_;      ///< points by bin, ascending within a bin
};

} // namespace riedel
