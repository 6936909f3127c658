#include "nonlocal/cell_list.hpp"

#include "nonlocal/kit/rows.hpp"

#include <bit>

namespace riedel {

template <int Dim>
void CellList<Dim>::find(const Columns& positions, double radius, NeighbourRows& rows) {
  require_finite<Dim>(positions);
  side_ = radius > 0.0 ? 0.5 * radius : 1.0;
  sort_into_bins(positions);
  fill_rows<Dim>(positions, radius, rows, [&](const Surroundings<Dim>& around, std::vector<Index>& list) {
    append_cells(cell_at(around.lower), cell_at(around.upper), list);
  });
}

template <int Dim>
void CellList<Dim>::sort_into_bins(const Columns& positions) {
  const Index points = positions.size();
  for (int a = 0; a < Dim; ++a) origin_[a] = points > 0 ? positions[a][0] : 0.0;
  const std::size_t bins = std::bit_ceil(static_cast<std::size_t>(points) + 1);
  last_bin_ = bins - 1;
  first_.assign(bins + 1, 0);
  bins_.resize(static_cast<std::size_t>(points));
  for_each_block(points, [&](Range block) {
    for (Index p = block.begin; p < block.end; ++p) {
      Vec<Dim> place;
      for (int a = 0; a < Dim; ++a) place[a] = positions[a][p];
      bins_[p] = bin_of(cell_at(place));
    }
  });
  for (const std::size_t bin : bins_) ++first_[bin];
  std::partial_sum(first_.begin(), first_.end(), first_.begin()); // now each bin's end; bins are filled backwards
  sorted_.resize(static_cast<std::size_t>(points));
  for (Index p = points; p-- > 0;) sorted_[--first_[bins_[p]]] = p;
}

/// Beyond 10⁹ cells from the first point, all of space is one cell, and numbers stay exact.
template <int Dim>
typename CellList<Dim>::Cell CellList<Dim>::cell_at(const Vec<Dim>& place) const {
  Cell cell;
  for (int a = 0; a < Dim; ++a)
    cell[a] = static_cast<std::int64_t>(std::clamp(std::floor((place[a] - origin_[a]) / side_), -1e9, 1e9));
  return cell;
}

/// Neighbouring cells along the first axis get neighbouring bins; the other axes are scattered by large odd factors.
template <int Dim>
std::size_t CellList<Dim>::bin_of(const Cell& cell) const {
  constexpr std::array<std::uint64_t, 3> factor = {1, 0x9E3779B97F4A7C15, 0xC2B2AE3D27D4EB4F};
  std::uint64_t hash = 0;
  for (std::size_t a = 0; a < Dim; ++a) hash += static_cast<std::uint64_t>(cell[a]) * factor[a];
  return hash & last_bin_;
}

/// Two cells may share a bin, which is then read twice: fill_rows handles that.
template <int Dim>
void CellList<Dim>::append_cells(const Cell& lower, const Cell& upper, std::vector<Index>& list) const {
  Cell cell = lower;
  while (true) {
    const std::size_t bin = bin_of(cell);
    list.insert(list.end(), sorted_.begin() + static_cast<std::ptrdiff_t>(first_[bin]),
                sorted_.begin() + static_cast<std::ptrdiff_t>(first_[bin + 1]));
    int a = 0;
    while (a < Dim && cell[a] == upper[a]) cell[a] = lower[a], ++a;
    if (a == Dim) return;
    ++cell[a];
  }
}

template class CellList<2>;
template class CellList<3>;

} // namespace riedel
