#include "nonlocal/cell_list.hpp"

#include "nonlocal/rows.hpp"

#include <bit>

namespace riedel {

template <int Dim>
void CellList<Dim>::find(const Columns& positions, double radius, NeighbourRows& rows) {
  require_finite<Dim>(positions);
  // A little wider than the radius, so that no rounding puts two neighbours further apart than adjacent cells.
  side_ = radius > 0.0 ? radius * (1.0 + 1e-6) : 1.0;
  sort_into_bins(positions);
  fill_rows<Dim>(positions, radius, rows,
                 [&](Index p, std::vector<Index>& list) { append_surroundings(cell_of(positions, p), list); });
}

template <int Dim>
void CellList<Dim>::sort_into_bins(const Columns& positions) {
  const Index points = positions.size();
  for (int a = 0; a < Dim; ++a) origin_[a] = points > 0 ? positions[a][0] : 0.0;
  const std::size_t bins = std::bit_ceil(static_cast<std::size_t>(points) + 1);
  last_bin_ = bins - 1;
  first_.assign(bins + 1, 0);
  for (Index p = 0; p < points; ++p) ++first_[bin_of(cell_of(positions, p))];
  std::partial_sum(first_.begin(), first_.end(), first_.begin()); // now each bin's end, to be filled backwards from
  sorted_.resize(static_cast<std::size_t>(points));
  for (Index p = points; p-- > 0;) sorted_[--first_[bin_of(cell_of(positions, p))]] = p;
}

/// Beyond a thousand million cells from the first point all of space is one cell, and numbers stay exact.
template <int Dim>
typename CellList<Dim>::Cell CellList<Dim>::cell_of(const Columns& positions, Index p) const {
  Cell cell;
  for (std::size_t a = 0; a < Dim; ++a) {
    const double x = std::floor((positions[static_cast<int>(a)][p] - origin_[static_cast<Index>(a)]) / side_);
    cell[a] = static_cast<std::int64_t>(std::clamp(x, -1e9, 1e9));
  }
  return cell;
}

/// Neighbouring cells along the first axis get neighbouring bins; the other axes are scattered by large odd numbers.
template <int Dim>
std::size_t CellList<Dim>::bin_of(const Cell& cell) const {
  constexpr std::array<std::uint64_t, 3> factor = {1, 0x9E3779B97F4A7C15, 0xC2B2AE3D27D4EB4F};
  std::uint64_t hash = 0;
  for (std::size_t a = 0; a < Dim; ++a) hash += static_cast<std::uint64_t>(cell[a]) * factor[a];
  return hash & last_bin_;
}

template <int Dim>
void CellList<Dim>::append_surroundings(const Cell& centre, std::vector<Index>& list) const {
  std::array<std::size_t, power(3, Dim)> bins;
  for (int k = 0; k < power(3, Dim); ++k) {
    Cell cell = centre;
    for (int a = 0, digits = k; a < Dim; ++a, digits /= 3) cell[a] += digits % 3 - 1;
    bins[k] = bin_of(cell);
  }
  std::ranges::sort(bins); // two cells may share a bin, which must be read once
  const auto end = std::unique(bins.begin(), bins.end());
  for (auto bin = bins.begin(); bin != end; ++bin)
    list.insert(list.end(), sorted_.begin() + static_cast<std::ptrdiff_t>(first_[*bin]),
                sorted_.begin() + static_cast<std::ptrdiff_t>(first_[*bin + 1]));
}

template class CellList<2>;
template class CellList<3>;

} // namespace riedel
