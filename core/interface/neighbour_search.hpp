/// Finds neighbouring points: from positions and a radius to rows of neighbours.
#pragma once

#include "core/base/columns.hpp"
#include "core/base/registry.hpp"

namespace riedel {

/// Neighbours of point p: index[start[p]] … index[start[p + 1] − 1], ascending, including p itself.
struct NeighbourRows {
  std::vector<std::int64_t> start;
  std::vector<Index> index;
};

/// Contract, tested for every registered search: the rows hold exactly the points with |x_p − x_q|² ≤ radius², where
/// the square is summed axis by axis in double precision, so that all searches agree to the last pair.
template <int Dim>
class NeighbourSearch {
public:
  virtual ~NeighbourSearch() = default;
  NeighbourSearch() = default;
  NeighbourSearch(const NeighbourSearch&) = delete;
  NeighbourSearch& operator=(const NeighbourSearch&) = delete;

  /// @param positions Dim columns [m] @param radius [m] @param rows overwritten; its memory is reused
  virtual void find(const Columns& positions, double radius, NeighbourRows& rows) = 0;
};

template <int Dim>
using NeighbourSearches = Registry<std::unique_ptr<NeighbourSearch<Dim>>()>;

/// |x_p − x_q|², summed as in the contract [m²].
template <int Dim>
double squared_distance(const Columns& positions, Index p, Index q) {
  double sum = 0.0;
  for (int a = 0; a < Dim; ++a) sum += square(positions[a][p] - positions[a][q]);
  return sum;
}

} // namespace riedel
