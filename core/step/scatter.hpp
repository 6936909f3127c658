/// The inner loops of both transfers: from eight points to the nodes of their stencils, and back.
#pragma once

#include "core/step/slab_order.hpp"

namespace riedel {

/// Eight rows, one for each of eight points: written and read by columns, used by rows.
template <int Width>
struct PointRows {
  alignas(64) std::array<std::array<double, Width>, pack_size> row;

  void put(int column, const Pack& values) {
    alignas(64) std::array<double, pack_size> lane;
    values.store(lane.data());
    for (int k = 0; k < pack_size; ++k) row[k][column] = lane[k];
  }
  [[nodiscard]] Pack column(int c) const {
    alignas(64) std::array<double, pack_size> lane;
    for (int k = 0; k < pack_size; ++k) lane[k] = row[k][c];
    return Pack::load(lane.data());
  }
};

/// What each of eight points gives to a node: N times a row of values and ∂N/∂x_a times a row of slopes, rows of sums.
template <int Dim>
class Shares {
public:
  /// Of no points yet; sums that are never put stay zero.
  Shares() {
    for (auto& row : value_.row) row.fill(0.0);
    for (auto& slope : slope_)
      for (auto& row : slope.row) row.fill(0.0);
  }
  void value(int sum, const Pack& of_points) { value_.put(sum, of_points); }
  void slope(int axis, int sum, const Pack& of_points) { slope_[axis].put(sum, of_points); }
  [[nodiscard]] const double* value_of(Index lane) const { return value_.row[lane].data(); }
  [[nodiscard]] const double* slope_of(int axis, Index lane) const { return slope_[axis].row[lane].data(); }

private:
  PointRows<pack_size> value_;
  std::array<PointRows<pack_size>, Dim> slope_;
};

/// sums_i += N_ip value_p + Σ_a ∂N_ip/∂x_a slope_pa for the lanes of the group.
template <int Dim>
void scatter(const SlabGroup<Dim>& group, const Shares<Dim>& shares, Nodes<Dim>& nodes) {
  const StencilEntries<Dim> entries = group.stencil;
  const int count = group.stencil.count;
  NodeSums<Dim>* const sums = nodes.sums.data();
  for (Index k = group.lanes.begin; k < group.lanes.end; ++k) {
    const Pack value = Pack::load(shares.value_of(k));
    std::array<Pack, Dim> slope;
    for (int a = 0; a < Dim; ++a) slope[a] = Pack::load(shares.slope_of(a, k));
    for (int entry = 0; entry < count; ++entry) {
      Pack share = Pack(entries.value_of(entry, k)) * value;
      for (int a = 0; a < Dim; ++a) share += Pack(entries.slope_of(entry, a, k)) * slope[a];
      sums[entries.node_of(entry, k)].add(share);
    }
  }
}

/// m_p v_p of eight points.
template <int Dim>
using Momenta = PointRows<Dim == 2 ? 2 : 4>;

/// (mv)_i += N_ip m_p v_p for the lanes of the group.
template <int Dim>
void scatter_momenta(const SlabGroup<Dim>& group, const Momenta<Dim>& momenta, Nodes<Dim>& nodes) {
  const StencilEntries<Dim> entries = group.stencil;
  const int count = group.stencil.count;
  NodeSums<Dim>* const sums = nodes.sums.data();
  for (Index k = group.lanes.begin; k < group.lanes.end; ++k) {
    const Vec<Dim> mv = Vec<Dim>::Map(momenta.row[k].data());
    for (int entry = 0; entry < count; ++entry)
      sums[entries.node_of(entry, k)].momentum += entries.value_of(entry, k) * mv;
  }
}

/// A node's motion summed over the stencils of eight points: rows of velocity, then acceleration.
template <int Dim>
using MotionRows = PointRows<sizeof(typename NodeMotion<Dim>::Record) / sizeof(double)>;

template <int Dim>
struct Gathered {
  MotionRows<Dim> values;                  ///< Σ_i N_ip (v_i, a_i)
  std::array<MotionRows<Dim>, Dim> slopes; ///< Σ_i ∂N_ip/∂x_a (v_i, a_i)
};

enum class Gather { values, slopes, both };

/// Fills what `what` asks for.
template <Gather what, int Dim>
void gather(const StencilGroup<Dim>& stencil, const Nodes<Dim>& nodes, Gathered<Dim>& sum) {
  using Record = typename NodeMotion<Dim>::Record;
  const StencilEntries<Dim> entries = stencil;
  const int count = stencil.count;
  const NodeMotion<Dim>* const motions = nodes.motion.data();
  for (int k = 0; k < pack_size; ++k) {
    Record value(0.0);
    std::array<Record, Dim> slope;
    slope.fill(Record(0.0));
    for (int entry = 0; entry < count; ++entry) {
      const Record motion = motions[entries.node_of(entry, k)].record();
      if constexpr (what != Gather::slopes) value += Record(entries.value_of(entry, k)) * motion;
      if constexpr (what != Gather::values)
        for (int a = 0; a < Dim; ++a) slope[a] += Record(entries.slope_of(entry, a, k)) * motion;
    }
    if constexpr (what != Gather::slopes) value.store(sum.values.row[k].data());
    if constexpr (what != Gather::values)
      for (int a = 0; a < Dim; ++a) slope[a].store(sum.slopes[a].row[k].data());
  }
}

} // namespace riedel
