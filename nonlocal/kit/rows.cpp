#include "nonlocal/kit/rows.hpp"

#include "core/base/pack.hpp"

#include <bit>

namespace riedel {

namespace {
constexpr Index nobody = -1; ///< fills the last pack of candidates, infinitely far away
} // namespace

template <int Dim>
void require_finite(const Columns& positions) {
  for (Index p = 0; p < positions.size(); ++p)
    for (int a = 0; a < Dim; ++a)
      if (!std::isfinite(positions[a][p]))
        throw RunError("point " + std::to_string(p) + " has no finite position; its neighbours cannot be searched for");
}

/// Slightly larger than the radius requires, so that round-off excludes no neighbour.
template <int Dim>
Surroundings<Dim> RowMaker<Dim>::surroundings(Range points) const {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  Surroundings<Dim> around;
  const double radius = radius_ * (1.0 + 1e-12) + std::numeric_limits<double>::min();
  double squared = 0.0;
  for (int a = 0; a < Dim; ++a) {
    const auto [lower, upper] = std::minmax_element(positions_[a] + points.begin, positions_[a] + points.end);
    around.lower[a] = std::nextafter(*lower - radius, -infinity);
    around.upper[a] = std::nextafter(*upper + radius, infinity);
    around.centre[a] = points.size() == 1 ? *lower : 0.5 * *lower + 0.5 * *upper;
    squared += square(std::max(around.centre[a] - *lower, *upper - around.centre[a]));
  }
  around.reach = radius + (1.0 + 1e-12) * std::sqrt(squared);
  return around;
}

/// Whether the points are within three radii. Otherwise most candidates would be far from most points.
template <int Dim>
bool RowMaker<Dim>::is_compact(const Surroundings<Dim>& around) const {
  return (around.upper - around.lower).maxCoeff() <= 5.0 * radius_;
}

/// Keeps the candidates in the box, once each, ascending, and loads their positions.
template <int Dim>
void RowMaker<Dim>::put_in_order(const Surroundings<Dim>& around) {
  std::size_t kept = 0;
  Index first = std::numeric_limits<Index>::max(), last = -1;
  for (const Index q : list_) {
    bool inside = true;
    for (int a = 0; a < Dim; ++a) inside &= positions_[a][q] >= around.lower[a] && positions_[a][q] <= around.upper[a];
    list_[kept] = q;
    kept += inside;
    first = std::min(first, inside ? q : first);
    last = std::max(last, inside ? q : last);
  }
  list_.resize(kept);
  const std::size_t words = static_cast<std::size_t>(last - first) / 64 + 1;
  if (words < 16 * kept) { // the usual case: much faster than sorting
    marks_.assign(words, 0);
    for (const Index q : list_) marks_[(q - first) / 64] |= std::uint64_t{1} << ((q - first) % 64);
    auto to = list_.begin();
    for (std::size_t w = 0; w < words; ++w)
      for (std::uint64_t bits = marks_[w]; bits != 0; bits &= bits - 1)
        *to++ = first + static_cast<Index>(64 * w) + std::countr_zero(bits);
    list_.erase(to, list_.end());
  } else {
    std::ranges::sort(list_);
    list_.erase(std::unique(list_.begin(), list_.end()), list_.end());
  }
  for (int a = 0; a < Dim; ++a) {
    near_[a].assign((list_.size() + pack_size - 1) / pack_size * pack_size, std::numeric_limits<double>::infinity());
    for (std::size_t k = 0; k < list_.size(); ++k) near_[a][k] = positions_[a][list_[k]];
  }
  list_.resize(near_[0].size(), nobody);
}

/// Selects the neighbours of p from the candidates. Packs may round a distance differently, so candidates on the radius
/// up to round-off are decided by the contract's sum, for every search by this one compiled function.
template <int Dim>
std::int64_t RowMaker<Dim>::keep_neighbours(Index p) {
  const double limit = square(radius_);
  const Pack near_limit = limit * 1e-12;
  const std::size_t before = rows_.size();
  rows_.resize(before + list_.size());
  Index* to = rows_.data() + before;
  for (std::size_t k = 0; k < list_.size(); k += pack_size) {
    Pack squared(0.0);
    for (int a = 0; a < Dim; ++a) {
      const Pack offset = Pack(positions_[a][p]) - Pack::load(near_[a].data() + k);
      squared += offset * offset;
    }
    auto inside = lanes(squared <= Pack(limit));
    if (!all(abs(squared - Pack(limit)) > near_limit))
      for (int i = 0; i < pack_size; ++i)
        inside[i] = list_[k + i] != nobody && squared_distance<Dim>(positions_, p, list_[k + i]) <= limit;
    for (int i = 0; i < pack_size; ++i) {
      *to = list_[k + i];
      to += inside[i];
    }
  }
  rows_.resize(static_cast<std::size_t>(to - rows_.data()));
  return static_cast<std::int64_t>(rows_.size() - before);
}

template void require_finite<2>(const Columns&);
template void require_finite<3>(const Columns&);
template class RowMaker<2>;
template class RowMaker<3>;

} // namespace riedel
