#include "nonlocal/gauss_grid.hpp"

#include "nonlocal/kit/rows.hpp"
#include "nonlocal/kit/weight.hpp"

#include <sstream>

namespace riedel {

namespace {

/// Variance along an axis of the cut-off Gaussian weight, in l_c² [-]: ½ (1 − 3^Dim exp(−9) / (Dim/2 γ(Dim/2, 9))).
template <int Dim>
constexpr double variance = 0.5 * (1.0 - (Dim == 2 ? 1.1108e-3 : 2.5077e-3));

/// Weights of the nodes −reach … reach of a filter of the given variance, in spacings²: a Gaussian, slightly widened
/// because it is cut off.
std::vector<double> gauss_taps(double variance_of_filter, Index reach) {
  std::vector<double> taps(static_cast<std::size_t>(2 * reach + 1));
  double parameter = variance_of_filter;
  for (int iteration = 0; iteration < 10; ++iteration) { // each reduces the error by at least two digits
    double sum = 0.0, squares = 0.0;
    for (Index k = -reach; k <= reach; ++k) {
      const double g = taps[k + reach] = std::exp(-0.5 * k * k / parameter);
      sum += g;
      squares += g * k * k;
    }
    for (double& g : taps) g /= sum;
    parameter *= variance_of_filter / (squares / sum);
  }
  return taps;
}

/// Computes a few packs of out(i) = Σ_k g_k in(i + k stride), k = 0 … last.
template <int packs>
void smooth_packs(const double* in, std::ptrdiff_t stride, const double* taps, Index last, double* out) {
  std::array<Pack, packs> sum;
  sum.fill(0.0);
  for (Index k = 0; k <= last; ++k, in += stride) {
    const Pack g = taps[k];
    for (int i = 0; i < packs; ++i) sum[i] += g * Pack::load(in + i * pack_size);
  }
  for (int i = 0; i < packs; ++i) sum[i].store(out + i * pack_size);
}

/// Calls `visit(row, N)` for the 3 [× 3] rows of three nodes around point i of a pack; N is the row's share.
template <int Dim, class Visit>
void for_each_row(const auto& N, Index i, const Counts<Dim>& stride, auto* base, const Visit& visit) {
  for (Index z = 0; z < (Dim == 2 ? 1 : 3); ++z)
    for (Index y = 0; y < 3; ++y) {
      if constexpr (Dim == 2)
        visit(base + y * stride[1], N[1][y][i]);
      else
        visit(base + y * stride[1] + z * stride[2], N[1][y][i] * N[2][z][i]);
    }
}

} // namespace

template <int Dim>
GaussGridAverager<Dim>::GaussGridAverager(double length, double spacing) : spacing_(spacing * length) {
  const double of_filter = variance<Dim> / square(spacing) - 0.5; // [Δ²]; each of the two splines adds a quarter
  reach_ = static_cast<Index>(std::ceil(3.5 * std::sqrt(of_filter)));
  margin_ = (reach_ + 3) / 4 * 4; // so that rows start on cache lines
  taps_ = gauss_taps(of_filter, reach_);
}

template <int Dim>
void GaussGridAverager<Dim>::update_neighbours(const Columns& positions) {
  const BoundingBox<Dim> box = bounding_box<Dim>(positions, nullptr, boxes_);
  if (points_ != positions.size() || !holds(box)) lay_out(positions, box);
  for_each_block(points_, [&](Range block) { place(positions, block); });
}

template <int Dim>
void GaussGridAverager<Dim>::average(const double* volumes, const double* field, double* averaged) {
  if (points_ == 0) return;
  const Index layer = stride_[Dim - 1], layers = count_[Dim - 1];
  parallel_for(layers, [&](Index l) { std::fill_n(nodes(0) + std::ptrdiff_t{l} * layer, layer, Load(0.0, 0.0)); });
  // A strip's points reach into the next strip. Every other strip is processed, then those between: no two at a time
  // share a node.
  const Index strips = (lead_ + layers + strip - 1) / strip;
  parallel_for((strips + 1) / 2, [&](Index s) { spread(2 * s, volumes, field); });
  parallel_for(strips / 2, [&](Index s) { spread(2 * s + 1, volumes, field); });
  for (int a = 0; a < Dim; ++a) smooth(a, nodes(a % 2), nodes((a + 1) % 2));
  for_each_block(points_, [&](Range block) { read(nodes(Dim % 2), block, averaged); });
}

/// The node nearest to a position, in spacings.
template <int Dim>
Vec<Dim> GaussGridAverager<Dim>::node_at(const Vec<Dim>& place) const {
  return (place.array() / spacing_ + 0.5).floor();
}

template <int Dim>
bool GaussGridAverager<Dim>::holds(const BoundingBox<Dim>& box) const {
  const Vec<Dim> lower = node_at(box.lower) - first_, upper = node_at(box.upper) - first_;
  for (int a = 0; a < Dim; ++a)
    if (!(lower[a] >= 1.0 && upper[a] <= count_[a] - 2.0)) return false;
  return true;
}

/// Covers the points, with one more node on each side, so that points at rest do not leave it by round-off.
template <int Dim>
void GaussGridAverager<Dim>::lay_out(const Columns& positions, const BoundingBox<Dim>& box) {
  points_ = 0;
  if (positions.size() == 0) return;
  require_finite<Dim>(positions);
  const Vec<Dim> first = node_at(box.lower).array() - 2.0, extent = node_at(box.upper).array() + 3.0 - first.array();
  if (const double nodes = extent.prod(); !(nodes <= nodes_per_point * positions.size() + nodes_more))
    refuse(positions, nodes);
  first_ = first;
  Index size = 1;
  for (int a = 0; a < Dim; ++a) {
    count_[a] = static_cast<Index>(extent[a]);
    stride_[a] = size;
    size *= a == 0 ? (count_[a] + margin_ + 3) / 4 * 4 : count_[a];
  }
  // Strips are counted from node 0 of all space, the even ones first, so that sums do not depend on the grid's extent.
  lead_ = static_cast<Index>(first[Dim - 1] - 2.0 * strip * std::floor(first[Dim - 1] / (2.0 * strip)));
  for (auto& copy : nodes_) copy.assign(static_cast<std::size_t>(size) + 2 * margin_, Load(0.0, 0.0));
  points_ = positions.size();
  offset_.resize(points_);
  base_.resize(static_cast<std::size_t>(points_));
  bases_.resize(static_cast<std::size_t>(blocks_of(points_)));
  ++layouts_;
}

/// Reports an oversized grid, with the point furthest from the centre of all points.
template <int Dim>
void GaussGridAverager<Dim>::refuse(const Columns& positions, double nodes) const {
  const auto place = [&](Index p) {
    Vec<Dim> x;
    for (int a = 0; a < Dim; ++a) x[a] = positions[a][p];
    return x;
  };
  Vec<Dim> middle = Vec<Dim>::Zero();
  for (Index p = 0; p < positions.size(); ++p) middle += place(p) / positions.size();
  Index furthest = 0;
  for (Index p = 0; p < positions.size(); ++p)
    if ((place(p) - middle).cwiseAbs().maxCoeff() > (place(furthest) - middle).cwiseAbs().maxCoeff()) furthest = p;
  std::ostringstream text;
  text << "gauss_grid would need " << nodes << " nodes, " << spacing_ << " m apart, for " << positions.size()
       << " points, of which point " << furthest << " at (" << place(furthest).transpose().format({6, 0, ", ", ", "})
       << ") m is furthest from the others; allowed are " << nodes_per_point << " per point and " << nodes_more
       << " more; averager gauss needs no grid";
  throw RunError(text.str());
}

/// The node nearest to each point of the block, and the offset of the point from it.
template <int Dim>
void GaussGridAverager<Dim>::place(const Columns& positions, Range block) {
  Range bases{std::numeric_limits<Index>::max(), 0};
  for (Index p = block.begin; p < block.end; p += pack_size) {
    Pack base(0.0);
    for (int a = 0; a < Dim; ++a) {
      const Pack x = Pack::load(positions[a] + p) * Pack(1.0 / spacing_), inner = first_[a] + 1.0;
      const Pack node = min(max(floor(x + Pack(0.5)), inner), inner + Pack(count_[a] - 3)); // despite round-off
      (x - node).store(offset_[a] + p);
      base += (node - inner) * Pack(stride_[a]);
    }
    std::array<double, pack_size> number;
    base.store(number.data());
    for (Index i = 0; i < std::min<Index>(pack_size, block.end - p); ++i) {
      base_[p + i] = static_cast<Index>(number[i]);
      bases = {std::min(bases.begin, base_[p + i]), std::max(bases.end, base_[p + i] + 1)};
    }
  }
  bases_[block.begin / block_size] = bases;
}

/// Quadratic B-splines of eight points at the three nearest nodes of each, along each axis.
template <int Dim>
void GaussGridAverager<Dim>::evaluate(Index p, Splines& N) const {
  for (int a = 0; a < Dim; ++a) {
    const Pack t = Pack::load(offset_[a] + p), left = Pack(0.5) - t, right = Pack(0.5) + t;
    (Pack(0.5) * left * left).store(N[a][0].data());
    (Pack(0.75) - t * t).store(N[a][1].data());
    (Pack(0.5) * right * right).store(N[a][2].data());
  }
}

/// Spreads the points whose base is in a strip, in the order of their indices.
template <int Dim>
void GaussGridAverager<Dim>::spread(Index number, const double* volumes, const double* field) {
  const Counts<Dim> stride = stride_;
  const Index begin = (number * strip - lead_) * stride[Dim - 1], end = begin + strip * stride[Dim - 1];
  Load* const first = nodes(0);
  Splines N;
  for (Index b = 0; b < blocks_of(points_); ++b) {
    if (bases_[b].end <= begin || bases_[b].begin >= end) continue;
    const Range block = block_range(b, points_);
    for (Index p = block.begin; p < block.end; p += pack_size) {
      evaluate(p, N);
      const Index in_pack = std::min<Index>(pack_size, block.end - p);
      for (Index i = 0; i < in_pack; ++i) {
        const Index base = base_[p + i];
        if (base < begin || base >= end) continue;
        const Load load(volumes[p + i], volumes[p + i] * field[p + i]);
        for_each_row<Dim>(N, i, stride, first + base, [&](Load* node, double share) {
          const Load part = share * load;
          for (int x = 0; x < 3; ++x) node[x] += N[0][x][i] * part;
        });
      }
    }
  }
}

/// Along one axis: to(i) = Σ_k g_k from(i + k), row by row of nodes. Beyond the grid all values are zero.
template <int Dim>
void GaussGridAverager<Dim>::smooth(int axis, const Load* from, Load* to) const {
  const std::ptrdiff_t stride = 2 * std::ptrdiff_t{stride_[axis]}; // in numbers, two per node
  parallel_for(rows(), [&](Index row) {
    const std::ptrdiff_t start = std::ptrdiff_t{row} * stride_[1];
    const Index place = axis == 0 ? 0 : row * stride_[1] / stride_[axis] % count_[axis];
    const Index lower = axis == 0 ? -reach_ : std::max(-reach_, -place);
    const Index upper = axis == 0 ? reach_ : std::min(reach_, count_[axis] - 1 - place);
    const double *in = from[start].data() + lower * stride, *taps = taps_.data() + reach_ + lower;
    double* out = to[start].data();
    const Index numbers = (2 * count_[0] + pack_size - 1) / pack_size * pack_size;
    Index i = 0;
    for (; i + 4 * pack_size <= numbers; i += 4 * pack_size)
      smooth_packs<4>(in + i, stride, taps, upper - lower, out + i);
    for (; i < numbers; i += pack_size) smooth_packs<1>(in + i, stride, taps, upper - lower, out + i);
    for (Index n = count_[0]; 2 * n < numbers; ++n) to[start + n] = Load(0.0, 0.0); // smoothed beyond the row
  });
}

template <int Dim>
void GaussGridAverager<Dim>::read(const Load* nodes, Range block, double* averaged) const {
  const Counts<Dim> stride = stride_;
  Splines N;
  for (Index p = block.begin; p < block.end; p += pack_size) {
    evaluate(p, N);
    for (Index i = 0; i < std::min<Index>(pack_size, block.end - p); ++i) {
      Load load(0.0, 0.0);
      for_each_row<Dim>(N, i, stride, nodes + base_[p + i], [&](const Load* node, double share) {
        load += share * (N[0][0][i] * node[0] + N[0][1][i] * node[1] + N[0][2][i] * node[2]);
      });
      averaged[p + i] = load[1] / load[0];
    }
  }
}

template class GaussGridAverager<2>;
template class GaussGridAverager<3>;

} // namespace riedel
