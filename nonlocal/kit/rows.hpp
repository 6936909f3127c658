/// Common to all searches: makes the rows required by the contract from candidates, however they were found.
#pragma once

#include "core/base/parallel.hpp"
#include "core/interface/neighbour_search.hpp"

#include <exception>
#include <numeric>

namespace riedel {

/// Throws RunError that names the first point whose position is not a finite number.
template <int Dim>
void require_finite(const Columns& positions);

/// Region that contains all neighbours of a few consecutive points: the intersection of this box and this ball.
template <int Dim>
struct Surroundings {
  Vec<Dim> lower, upper; ///< corners of the box [m]
  Vec<Dim> centre;       ///< [m]
  double reach;          ///< radius of the ball around the centre [m]
};

/// Makes the rows of one block. Consecutive points are usually near each other, so their candidates are searched for
/// and sorted only once.
template <int Dim>
class RowMaker {
public:
  static constexpr Index group = 16; ///< maximum number of consecutive points processed together

  RowMaker(const Columns& positions, double radius) : positions_(positions), radius_(radius) {}

  /// Appends the rows of the points to `row_`, and their lengths to `lengths`.
  /// @param candidates `candidates(surroundings, list)` appends every point in both of them and possibly others
  template <class Candidates>
  void append(Range points, std::int64_t* lengths, const Candidates& candidates) {
    const Surroundings<Dim> around = surroundings(points);
    if (points.size() > group || (points.size() > 1 && !is_compact(around))) {
      const Index middle = points.begin + points.size() / 2;
      append({points.begin, middle}, lengths, candidates);
      return append({middle, points.end}, lengths + (middle - points.begin), candidates);
    }
    list_.clear();
    candidates(around, list_);
    put_in_order(around);
    for (Index p = points.begin; p < points.end; ++p) *lengths++ = keep_neighbours(p);
  }
  [[nodiscard]] std::vector<Index>&& take() { return std::move(rows_); }

private:
  [[nodiscard]] Surroundings<Dim> surroundings(Range points) const;
  [[nodiscard]] bool is_compact(const Surroundings<Dim>& around) const;
  void put_in_order(const Surroundings<Dim>& around);
  std::int64_t keep_neighbours(Index p);

  const Columns& positions_;
  double radius_;
  std::vector<Index> rows_;
  std::vector<Index> list_;                     ///< candidates
  std::vector<std::uint64_t> marks_;            ///< one bit per point between the first and the last candidate
  std::array<AlignedVector<double>, Dim> near_; ///< positions of the candidates, padded to whole packs [m]
};

/// `for_each_block` for a body that may throw, as for lack of memory: one of the exceptions is rethrown at the end.
template <class Body>
void for_each_block_that_may_throw(Index points, const Body& body) {
  std::exception_ptr thrown;
  for_each_block(points, [&](Range block) {
    try {
      body(block);
    } catch (...) {
#pragma omp critical(riedel_thrown_by_a_block)
      if (!thrown) thrown = std::current_exception();
    }
  });
  if (thrown) std::rethrow_exception(thrown);
}

/// Fills the rows, several blocks of points at once; they do not depend on the number of threads.
template <int Dim, class Candidates>
void fill_rows(const Columns& positions, double radius, NeighbourRows& rows, const Candidates& candidates) {
  const Index points = positions.size();
  std::vector<std::vector<Index>> parts(static_cast<std::size_t>(blocks_of(points)));
  rows.start.assign(static_cast<std::size_t>(points) + 1, 0);
  for_each_block_that_may_throw(points, [&](Range block) {
    RowMaker<Dim> maker(positions, radius);
    maker.append(block, rows.start.data() + block.begin + 1, candidates);
    parts[block.begin / block_size] = maker.take();
  });
  std::partial_sum(rows.start.begin(), rows.start.end(), rows.start.begin());
  rows.index.clear(); // otherwise its memory might be doubled
  rows.index.resize(static_cast<std::size_t>(rows.start.back()));
  for_each_block(points, [&](Range block) {
    std::ranges::copy(parts[block.begin / block_size], rows.index.begin() + rows.start[block.begin]);
  });
}

} // namespace riedel
