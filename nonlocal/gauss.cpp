#include "nonlocal/gauss.hpp"

#include "nonlocal/kit/rows.hpp"

#include <numeric>

namespace riedel {

namespace {

constexpr Index width = pack_size; ///< points in a run

Pack widen(const float* from) {
  std::array<double, width> wide;
  for (int i = 0; i < width; ++i) wide[i] = from[i];
  return Pack::load(wide.data());
}

void narrow(const Pack& from, float* to) {
  std::array<double, width> wide;
  from.store(wide.data());
  for (int i = 0; i < width; ++i) to[i] = static_cast<float>(wide[i]);
}

/// Sums the lanes in a fixed order, two halves at a time.
double sum_of(const Pack& a) {
  std::array<double, width> x;
  a.store(x.data());
  return ((x[0] + x[4]) + (x[2] + x[6])) + ((x[1] + x[5]) + (x[3] + x[7]));
}

} // namespace

template <int Dim>
GaussAverager<Dim>::GaussAverager(double length, std::unique_ptr<NeighbourSearch<Dim>> search)
    : length_(length), weight_of_(length), search_(std::move(search)) {}

template <int Dim>
void GaussAverager<Dim>::invalidate() {
  points_ = 0;
}

template <int Dim>
void GaussAverager<Dim>::update_neighbours(const Columns& positions) {
  if (points_ == positions.size() && !shifted(positions, places_, 2.0 * weights_last * length_)) return;
  if (points_ != positions.size() || shifted(positions, searched_at_, skin * length_)) search(positions);
  for (int a = 0; a < Dim; ++a) std::copy_n(positions[a], points_, places_[a]);
  for_each_block(teams_of(points_), [&](Range block) { evaluate_weights(block); });
}

template <int Dim>
void GaussAverager<Dim>::average(const double* volumes, const double* field, double* averaged) {
  double *volume = load_[0], *moment = load_[1];
  for_each_block(points_, [&](Range block) {
    for (Index p = block.begin; p < block.end; ++p) {
      volume[p] = volumes[p];
      moment[p] = volumes[p] * field[p];
    }
  });
  for_each_block(teams_of(points_), [&](Range block) { sum(block, averaged); });
}

/// d*(x_p) = Σ_q ω_pq V_q d_q / Σ_q ω_pq V_q   (1)
template <int Dim>
void GaussAverager<Dim>::sum(Range teams, double* averaged) const {
  const double *volumes = load_[0], *moments = load_[1];
  for (Index t = teams.begin; t < teams.end; ++t) {
    std::array<Pack, team> volume, moment;
    volume.fill(0.0);
    moment.fill(0.0);
    for (std::int64_t r = first_run_[t]; r < first_run_[t + 1]; ++r) {
      const Pack V = Pack::load(volumes + run_[r]), Vd = Pack::load(moments + run_[r]);
      for (int i = 0; i < team; ++i) {
        const Pack omega = widen(weight_.data() + (r * team + i) * width);
        volume[i] += omega * V;
        moment[i] += omega * Vd;
      }
    }
    for (int i = 0; i < team && t * team + i < points_; ++i)
      averaged[t * team + i] = sum_of(moment[i]) / sum_of(volume[i]);
  }
}

template <int Dim>
void GaussAverager<Dim>::search(const Columns& positions) {
  NeighbourRows rows;
  search_->find(positions, (GaussWeight::cut + skin) * length_, rows);
  ++searches_;
  searched_at_ = positions;
  points_ = positions.size();
  load_.resize(points_ + width); // zeros at the end, since runs may extend beyond the last point
  places_.resize(points_ + width);
  for (int a = 0; a < Dim; ++a) std::fill_n(places_[a] + points_, width, std::numeric_limits<double>::infinity());
  boxes_.resize(static_cast<std::size_t>(blocks_of(points_)));
  lay_runs(rows);
}

/// Merges the rows of a team's points, both ascending, to runs: each starts at the first neighbour not yet covered.
template <int Dim>
void GaussAverager<Dim>::append_runs(const NeighbourRows& rows, Index t, std::vector<Index>& runs) const {
  constexpr Index none = std::numeric_limits<Index>::max();
  std::array<const Index*, team> next, end;
  for (Index i = 0; i < team; ++i) {
    next[i] = rows.index.data() + rows.start[std::min(t * team + i, points_)];
    end[i] = rows.index.data() + rows.start[std::min(t * team + i + 1, points_)];
  }
  while (true) {
    Index first = none;
    for (int i = 0; i < team; ++i) first = std::min(first, next[i] < end[i] ? *next[i] : none);
    if (first == none) return;
    runs.push_back(first);
    for (int i = 0; i < team; ++i)
      while (next[i] < end[i] && *next[i] < first + width) ++next[i];
  }
}

template <int Dim>
void GaussAverager<Dim>::lay_runs(const NeighbourRows& rows) {
  const Index teams = teams_of(points_);
  first_run_.assign(static_cast<std::size_t>(teams) + 1, 0);
  std::vector<std::vector<Index>> parts(static_cast<std::size_t>(blocks_of(teams)));
  for_each_block_that_may_throw(teams, [&](Range block) {
    std::vector<Index>& part = parts[block.begin / block_size];
    for (Index t = block.begin; t < block.end; ++t) {
      const std::size_t before = part.size();
      append_runs(rows, t, part);
      first_run_[t + 1] = static_cast<std::int64_t>(part.size() - before);
    }
  });
  std::partial_sum(first_run_.begin(), first_run_.end(), first_run_.begin());
  run_.clear(); // otherwise its memory might be doubled
  run_.resize(static_cast<std::size_t>(first_run_.back()));
  weight_.clear();
  weight_.resize(run_.size() * team * width);
  for_each_block(teams, [&](Range block) {
    std::ranges::copy(parts[block.begin / block_size], run_.begin() + first_run_[block.begin]);
  });
}

template <int Dim>
void GaussAverager<Dim>::evaluate_weights(Range teams) {
  using Floats = xsimd::batch<float>;
  std::array<float, team * width> squares; // (r/l_c)²
  static_assert(squares.size() % Floats::size == 0);
  for (Index t = teams.begin; t < teams.end; ++t)
    for (std::int64_t r = first_run_[t]; r < first_run_[t + 1]; ++r) {
      for (Index i = 0; i < team; ++i) {
        Pack sum(0.0);
        for (int a = 0; a < Dim; ++a) {
          const double* x = places_[a];
          const Pack offset = Pack::load(x + run_[r]) - Pack(x[t * team + i]);
          sum += offset * offset;
        }
        narrow(weight_of_.scaled(sum), squares.data() + i * width);
      }
      float* omega = weight_.data() + r * team * width;
      for (std::size_t i = 0; i < squares.size(); i += Floats::size)
        GaussWeight::at(Floats::load_unaligned(squares.data() + i)).store_unaligned(omega + i);
    }
}

/// Whether the vector between any two points has changed by more than `distance` [m], or a position is not a number.
template <int Dim>
bool GaussAverager<Dim>::shifted(const Columns& positions, const Columns& since, double distance) {
  if (points_ == 0) return false;
  const BoundingBox<Dim> ways = bounding_box(positions, &since, boxes_);
  return !((ways.upper - ways.lower).norm() <= distance);
}

template class GaussAverager<2>;
template class GaussAverager<3>;

} // namespace riedel
