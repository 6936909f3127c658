/// Interpolation weights of many points: N_ip and ∇N_ip, eight points at a time.
#pragma once

#include "core/base/columns.hpp"
#include "core/base/pack.hpp"

namespace riedel {

/// The stencils of eight consecutive points, one per lane. Entry a of lane k stands at a·8 + k; a node may appear in
/// more than one entry of a point.
template <int Dim>
struct StencilGroup {
  int count = 0;                         ///< entries in use
  std::array<Index, pack_size> lowest{}; ///< least and greatest index along the last axis of the nodes in each lane
  std::array<Index, pack_size> highest{};
  std::array<bool, pack_size> lost{}; ///< this lane's support leaves the grid; its weights are zero
  Index* node = nullptr;              ///< [count][8]
  double* value = nullptr;            ///< N_ip [-], [count][8]
  double* slope = nullptr;            ///< ∂N_ip/∂x_d [1/m], [count][Dim][8]

  void set_value(int entry, const Pack& N) { N.store(value + entry * pack_size); }
  /// Node numbers of an entry: each lane's base and a common offset.
  void set_nodes(int entry, const std::array<Index, pack_size>& base, Index offset) {
    for (int k = 0; k < pack_size; ++k) node[entry * pack_size + k] = base[k] + offset;
  }
  void set_slope(int entry, int axis, const Pack& dN) { dN.store(slope + (entry * Dim + axis) * pack_size); }
  /// Zeroes the weights of lost lanes, so that they may be used without a look at the flags.
  void drop_lost_lanes() {
    for (std::size_t k = 0; k < pack_size; ++k) {
      if (!lost[k]) continue;
      for (std::size_t i = k; i < static_cast<std::size_t>(count * pack_size); i += pack_size)
        node[i] = 0, value[i] = 0;
      for (std::size_t i = k; i < static_cast<std::size_t>(count * Dim * pack_size); i += pack_size) slope[i] = 0;
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
