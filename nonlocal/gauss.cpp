#include "nonlocal/gauss.hpp"

#include "core/base/parallel.hpp"

namespace riedel {

template <int Dim>
GaussAverager<Dim>::GaussAverager(double length, std::unique_ptr<NeighbourSearch<Dim>> search)
    : length_(length), weight_of_(length), search_(std::move(search)) {}

template <int Dim>
void GaussAverager<Dim>::forget_neighbours() {
  searched_at_.resize(0);
  weighed_at_.resize(0);
}

template <int Dim>
void GaussAverager<Dim>::follow(const Columns& positions) {
  if (!moved(positions, weighed_at_, weights_last * length_)) return;
  if (moved(positions, searched_at_, 0.5 * skin * length_)) search(positions);
  for_each_block(positions.size(), [&](Range block) { weigh(positions, block); });
  weighed_at_ = positions;
}

/// Both sums run over the neighbours by rising number, and a pair beyond 3 l_c adds exactly nothing, so the result does
/// not depend on when the neighbours were searched for.
template <int Dim>
void GaussAverager<Dim>::average(const double* volumes, const double* field, double* averaged) {
  const Index points = static_cast<Index>(load_.size());
  for_each_block(points, [&](Range block) {
    for (Index p = block.begin; p < block.end; ++p) load_[p] = {volumes[p], volumes[p] * field[p]};
  });
  for_each_block(points, [&](Range block) {
    for (Index p = block.begin; p < block.end; ++p) {
      double volume = 0.0, moment = 0.0;
      for (std::int64_t k = rows_.start[p]; k < rows_.start[p + 1]; ++k) {
        const Load& q = load_[rows_.index[k]];
        volume += weight_[k] * q.volume;
        moment += weight_[k] * q.moment;
      }
      averaged[p] = moment / volume; // d*(x_p) = Σ_q ω_pq V_q d_q / Σ_q ω_pq V_q   (1)
    }
  });
}

template <int Dim>
void GaussAverager<Dim>::search(const Columns& positions) {
  search_->find(positions, (GaussWeight::cut + skin) * length_, rows_);
  ++searches_;
  searched_at_ = positions;
  weight_.resize(rows_.index.size());
  load_.resize(static_cast<std::size_t>(positions.size()));
  stayed_.resize(static_cast<std::size_t>(blocks_of(positions.size())));
}

/// ω of every pair of the block: first all distances, then the weights, eight at a time.
template <int Dim>
void GaussAverager<Dim>::weigh(const Columns& positions, Range block) {
  for (Index p = block.begin; p < block.end; ++p)
    for (std::int64_t k = rows_.start[p]; k < rows_.start[p + 1]; ++k)
      weight_[k] = squared_distance<Dim>(positions, p, rows_.index[k]);
  double* omega = weight_.data() + rows_.start[block.begin];
  double* const end = weight_.data() + rows_.start[block.end];
  for (; end - omega >= pack_size; omega += pack_size) weight_of_(Pack::load(omega)).store(omega);
  std::array<double, pack_size> rest{}; // a pack too, since a single exp may round otherwise
  std::copy(omega, end, rest.begin());
  weight_of_(Pack::load(rest.data())).store(rest.data());
  std::copy_n(rest.begin(), end - omega, omega);
}

/// Has any point moved further than `distance` [m]? Yes when their number has changed or a position is not a number.
template <int Dim>
bool GaussAverager<Dim>::moved(const Columns& positions, const Columns& since, double distance) {
  if (since.size() != positions.size()) return true;
  const Pack limit = square(distance);
  const auto stayed = [&](Range block) {
    bool near = true;
    for (Index p = block.begin; p < block.end; p += pack_size) { // columns are padded to whole packs
      Pack squared(0.0);
      for (int a = 0; a < Dim; ++a) {
        const Pack way = Pack::load(positions[a] + p) - Pack::load(since[a] + p);
        squared += way * way;
      }
      near = near && all(squared <= limit);
    }
    return static_cast<char>(near);
  };
  const auto both = [](char a, char b) { return static_cast<char>(a && b); };
  return reduce_blocks(positions.size(), stayed_, char{1}, stayed, both) == 0;
}

template class GaussAverager<2>;
template class GaussAverager<3>;

} // namespace riedel
