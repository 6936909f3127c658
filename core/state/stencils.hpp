/// Interpolation weights of many points: N_ip and ∇N_ip, eight points at a time.
#pragma once

#include "core/base/columns.hpp"
#include "core/base/pack.hpp"

#include <cstring>

namespace riedel {

/// The entries of eight stencils, one stencil per lane: entry a of lane k stands at a·8 + k. Copied by value into
/// loops, so that the compiler knows that the pointers stay what they are.
template <int Dim>
struct StencilEntries {
  Index* node = nullptr;   ///< [count][8]
  double* value = nullptr; ///< N_ip [-], [count][8]
  double* slope = nullptr; ///< ∂N_ip/∂x_d [1/m], [count][Dim][8]

  void set_value(int entry, const Pack& N) const { N.store(value + entry * pack_size); }
  void set_slope(int entry, int axis, const Pack& dN) const { dN.store(slope + (entry * Dim + axis) * pack_size); }
  /// Node numbers of an entry: each lane's base and a common offset.
  void set_nodes(int entry, const std::array<Index, pack_size>& base, Index offset) const {
    typedef Index Lanes __attribute__((vector_size(pack_size * sizeof(Index)))); // g++ leaves a plain loop to scalars
    Lanes lanes;
    std::memcpy(&lanes, base.data(), sizeof(lanes));
    lanes += offset;
    std::memcpy(node + entry * pack_size, &lanes, sizeof(lanes));
  }
  [[nodiscard]] Index node_of(int entry, Index lane) const { return node[entry * pack_size + lane]; }
  [[nodiscard]] double value_of(int entry, Index lane) const { return value[entry * pack_size + lane]; }
  [[nodiscard]] double slope_of(int entry, int axis, Index lane) const {
    return slope[(entry * Dim + axis) * pack_size + lane];
  }
};

/// The stencils of eight consecutive points; a node may appear in more than one entry of a point.
template <int Dim>
struct StencilGroup : StencilEntries<Dim> {
  int count = 0;                         ///< entries in use
  std::array<Index, pack_size> lowest{}; ///< least and greatest index along the last axis of the nodes in each lane
  std::array<Index, pack_size> highest{};
  std::array<bool, pack_size> lost{}; ///< this lane's support leaves the grid; its weights are zero

  /// Marks the lanes that are not in `inside` as lost and zeroes their weights, so that these may be used without a
  /// look at the flags.
  void keep_lanes(const Mask& inside) {
    lost.fill(false);
    if (all(inside)) return;
    const std::array<bool, pack_size> kept = lanes(inside);
    for (int k = 0; k < pack_size; ++k) {
      lost[k] = !kept[k];
      if (kept[k]) continue;
      for (int i = k; i < count * pack_size; i += pack_size) this->node[i] = 0, this->value[i] = 0;
      for (int i = k; i < count * Dim * pack_size; i += pack_size) this->slope[i] = 0;
    }
  }
};

template <int Dim>
class Stencils {
public:
  /// Room for the stencils of `points` points.
  void resize(Index points, int max_nodes) {
    const std::size_t groups = static_cast<std::size_t>((points + pack_size - 1) / pack_size);
    const std::size_t entries = groups * static_cast<std::size_t>(max_nodes * pack_size);
    node_.assign(entries, 0);
    value_.assign(entries, 0.0);
    slope_.assign(entries * Dim, 0.0);
    groups_.assign(groups, {});
    for (std::size_t g = 0; g < groups; ++g) {
      const std::size_t at = g * static_cast<std::size_t>(max_nodes * pack_size);
      groups_[g].node = node_.data() + at;
      groups_[g].value = value_.data() + at;
      groups_[g].slope = slope_.data() + at * Dim;
    }
  }
  /// From now on the first group is that of `first`, a multiple of eight.
  void begin_at(Index first) { first_ = first / pack_size; }
  /// The group that holds point p; p's lane in it is p mod 8.
  [[nodiscard]] StencilGroup<Dim>& group_of(Index p) {
    return groups_[static_cast<std::size_t>(p / pack_size - first_)];
  }
  [[nodiscard]] const StencilGroup<Dim>& group_of(Index p) const {
    return groups_[static_cast<std::size_t>(p / pack_size - first_)];
  }

private:
  Index first_ = 0; ///< groups before the one that is kept first
  std::vector<StencilGroup<Dim>> groups_;
  AlignedVector<Index> node_;
  AlignedVector<double> value_, slope_;
};

} // namespace riedel
