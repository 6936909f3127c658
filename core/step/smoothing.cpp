#include "core/step/smoothing.hpp"

#include "core/step/group_walk.hpp"
#include "core/step/kernels/stencil_walk.hpp"
#include "core/step/slab_order.hpp"

#include <Eigen/Eigenvalues>
#include <limits>

namespace riedel {

namespace {

constexpr int weight_at = 7; ///< lane of a row that holds 1, whose sums are the nodes' volumes
using EightRows = std::array<ShortVector<8>, pack_size>;

/// sum_i += N_ip row_p for the lanes of a patch. Lanes in a row that touch the same nodes are summed before anything is
/// written.
template <std::size_t Shape, int Dim>
[[gnu::always_inline]] inline void scatter_rows(PatchLane<Shape, Dim> lane, Range lanes, const EightRows& rows,
                                                ShortVector<8>* nodes) {
  constexpr int entries = PatchLane<Shape, Dim>::entries;
  for (Index k = lanes.begin; k < lanes.end;) {
    const PatchLane<Shape, Dim> first = lane;
    std::array<ShortVector<8>, entries> sum;
    first.for_each_node(nodes, [&](int e, const ShortVector<8>& node) { sum[e] = node; });
    do {
      for (int e = 0; e < entries; ++e) sum[e] += lane.value_of(e) * rows[k];
      lane.to_next_lane();
    } while (++k < lanes.end && *lane.base == *first.base);
    first.for_each_node(nodes, [&](int e, ShortVector<8>& node) { node = sum[e]; });
  }
}

/// Σ_i N_ip node_i of eight points.
template <int Dim>
void gather_rows(const StencilEntries<Dim>& stencil, const AlignedVector<ShortVector<8>>& nodes, EightRows& rows) {
  const StencilEntries<Dim> entries = stencil;
  with_shape(entries.shape, [&](auto shape) {
    PatchLane<shape, Dim> lane(entries, 0);
    for (Index k = 0; k < pack_size; ++k, lane.to_next_lane()) {
      ShortVector<8> sum(0.0);
      PatchLane<shape, Dim> patch = lane;
      for (int n = 0; n < entries.count; n += patch.entries, patch.to_next_patch())
        patch.for_each_node(nodes.data(), [&](int e, const ShortVector<8>& node) { sum += patch.value_of(e) * node; });
      rows[k] = sum;
    }
  });
}

/// sum_i = Σ_p N_ip V_p a_p; `fill(group, rows)` gives the a_p of eight points.
template <int Dim, class Fill>
void sum_up(State<Dim>& state, const Model<Dim>& model, Body<Dim>& body, const Fill& fill) {
  AlignedVector<ShortVector<8>>& sum = state.nodes.smoothing.sum;
  parallel_for(state.nodes.size(), [&](Index i) { sum[i] = ShortVector<8>(0.0); });
  add_in_slab_order<EightRows>(state, model, body, [&](const SlabGroup<Dim>& group, EightRows& rows) {
    fill(group, rows);
    const double* const V = body.points.volume[0] + group.first;
    for (Index k = group.lanes.begin; k < group.lanes.end; ++k) rows[k] = V[k] * rows[k];
    const StencilEntries<Dim> stencil = group.stencil;
    with_shape(stencil.shape, [&](auto shape) {
      PatchLane<shape, Dim> patch(stencil, group.lanes.begin);
      for (int n = 0; n < stencil.count; n += patch.entries, patch.to_next_patch())
        scatter_rows(patch, group.lanes, rows, sum.data());
    });
  });
}

/// (1, x, y …) of a point, in cells from the centre of the grid.
template <int Dim>
Eigen::Matrix<double, Dim + 1, 1> coordinates(const Grid<Dim>& grid, const Points<Dim>& points, Index p) {
  Eigen::Matrix<double, Dim + 1, 1> x;
  x[0] = 1.0;
  for (int a = 0; a < Dim; ++a)
    x[a + 1] = (points.position[a][p] - grid.origin[a]) / grid.cell[a] - 0.5 * static_cast<double>(grid.nodes[a]);
  return x;
}

template <int Dim>
FieldMoments<Dim> no_moments() {
  FieldMoments<Dim> none;
  none.fields.fill(ShortVector<8>(0.0));
  none.weights.setZero();
  return none;
}

template <int Dim>
FieldMoments<Dim> moments(const Grid<Dim>& grid, const Body<Dim>& body, Range block) {
  FieldMoments<Dim> sum = no_moments<Dim>();
  for (Index p = block.begin; p < block.end; ++p) {
    const auto x = coordinates(grid, body.points, p);
    const double V = body.points.volume[0][p];
    for (int a = 0; a <= Dim; ++a) sum.fields[a] += V * x[a] * body.fields[p];
    sum.weights += V * x * x.transpose();
  }
  return sum;
}

/// The inverse, or the pseudo-inverse if the points lie on a line or a plane.
template <int Size>
Eigen::Matrix<double, Size, Size> inverse(const Eigen::Matrix<double, Size, Size>& weights) {
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix<double, Size, Size>> solver(weights);
  const double minimum = 1e-12 * solver.eigenvalues()[Size - 1];
  Eigen::Matrix<double, Size, 1> values;
  for (int a = 0; a < Size; ++a) values[a] = solver.eigenvalues()[a] > minimum ? 1.0 / solver.eigenvalues()[a] : 0.0;
  return solver.eigenvectors() * values.asDiagonal() * solver.eigenvectors().transpose();
}

} // namespace

/// (I − S)^m a = a − N u with u = Σ_k t_k, t_1 = M⁻¹ Nᵀ V a, t_{k+1} = (I − M⁻¹ Nᵀ V N) t_k, k up to m: all passes
/// except the first and the last work on nodal values.
template <int Dim>
void subtract_smooth(State<Dim>& state, const Model<Dim>& model, Body<Dim>& body, int m) {
  SmoothingNodes& nodes = state.nodes.smoothing;
  sum_up(state, model, body, [&](const SlabGroup<Dim>& group, EightRows& rows) {
    for (Index k = 0; k < pack_size; ++k) {
      rows[k] = body.fields[group.first + k];
      rows[k].lanes[weight_at] = 1.0;
    }
  });
  parallel_for(state.nodes.size(), [&](Index i) {
    const double volume = nodes.sum[i].lanes[weight_at];
    nodes.per_volume[i] = volume > std::numeric_limits<double>::min() ? 1.0 / volume : 0.0;
    nodes.term[i] = nodes.total[i] = nodes.per_volume[i] * nodes.sum[i];
  });
  for (int k = 1; k < m; ++k) {
    sum_up(state, model, body,
           [&](const SlabGroup<Dim>& group, EightRows& rows) { gather_rows(group.stencil, nodes.term, rows); });
    parallel_for(state.nodes.size(), [&](Index i) {
      nodes.term[i] -= nodes.per_volume[i] * nodes.sum[i];
      nodes.total[i] += nodes.term[i];
    });
  }
  for_each_group(state, model, body, [&](Body<Dim>&, const StencilGroup<Dim>& stencil, Index p) {
    EightRows smooth;
    gather_rows(stencil, nodes.total, smooth);
    for (Index k = 0; k < pack_size; ++k) body.fields[p + k] -= smooth[k];
  });
}

template <int Dim>
void subtract_linear(State<Dim>& state, Body<Dim>& body) {
  const FieldMoments<Dim> sum = reduce_blocks(
      body.points.size(), state.field_moments, no_moments<Dim>(),
      [&](Range block) { return moments(state.grid, body, block); },
      [](FieldMoments<Dim> a, const FieldMoments<Dim>& b) {
        for (int i = 0; i <= Dim; ++i) a.fields[i] += b.fields[i];
        a.weights += b.weights;
        return a;
      });
  const auto per_weight = inverse(sum.weights);
  std::array<ShortVector<8>, Dim + 1> gradients;
  for (int a = 0; a <= Dim; ++a) {
    gradients[a] = ShortVector<8>(0.0);
    for (int b = 0; b <= Dim; ++b) gradients[a] += per_weight(a, b) * sum.fields[b];
  }
  for_each_block(body.points.size(), [&](Range block) {
    for (Index p = block.begin; p < block.end; ++p) {
      const auto x = coordinates(state.grid, body.points, p);
      for (int a = 0; a <= Dim; ++a) body.fields[p] -= x[a] * gradients[a];
    }
  });
}

template void subtract_smooth<2>(State<2>&, const Model<2>&, Body<2>&, int);
template void subtract_smooth<3>(State<3>&, const Model<3>&, Body<3>&, int);
template void subtract_linear<2>(State<2>&, Body<2>&);
template void subtract_linear<3>(State<3>&, Body<3>&);

} // namespace riedel
