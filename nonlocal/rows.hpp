/// What all searches share: from candidates, found in whatever way, to the rows that the contract asks for.
#pragma once

#include "core/base/parallel.hpp"
#include "core/interface/neighbour_search.hpp"

#include <numeric>

namespace riedel {

/// Throws RunError that names the first point whose position is not a finite number.
template <int Dim>
void require_finite(const Columns& positions);

/// Of the entries of `list` from `first` on, keeps the neighbours of p, rising. Every search decides by this one
/// compiled function, so that none rounds a distance in its own way.
template <int Dim>
void keep_neighbours(const Columns& positions, Index p, double radius, std::size_t first, std::vector<Index>& list);

/// Fills the rows, blocks of points at once; they do not depend on the number of threads.
/// @param candidates `candidates(p, list)` appends every neighbour of p and perhaps others, each once
template <int Dim, class Candidates>
void fill_rows(const Columns& positions, double radius, NeighbourRows& rows, const Candidates& candidates) {
  const Index points = positions.size();
  std::vector<std::vector<Index>> parts(static_cast<std::size_t>(blocks_of(points)));
  rows.start.assign(static_cast<std::size_t>(points) + 1, 0);
  for_each_block(points, [&](Range block) {
    std::vector<Index>& part = parts[block.begin / block_size];
    for (Index p = block.begin; p < block.end; ++p) {
      const std::size_t first = part.size();
      candidates(p, part);
      keep_neighbours<Dim>(positions, p, radius, first, part);
      rows.start[p + 1] = static_cast<std::int64_t>(part.size() - first);
    }
  });
  std::partial_sum(rows.start.begin(), rows.start.end(), rows.start.begin());
  rows.index.resize(static_cast<std::size_t>(rows.start.back()));
  for_each_block(points, [&](Range block) {
    std::ranges::copy(parts[block.begin / block_size], rows.index.begin() + rows.start[block.begin]);
  });
}

} // namespace riedel
