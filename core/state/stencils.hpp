/// Interpolation weights of many points: N_ip and ∇N_ip, eight points at a time.
#pragma once

#include "core/base/columns.hpp"
#include "core/base/pack.hpp"

namespace riedel {

/// Nodes found from one base: rows of neighbours along the first axis.
struct PatchShape {
  int rows, length;
  [[nodiscard]] constexpr int entries() const { return rows * length; }
  constexpr bool operator==(const PatchShape&) const = default;
};

/// The shapes that the transfers support; the last one, entry by entry, always works.
constexpr std::array<PatchShape, 5> patch_shapes{{{3, 3}, {2, 2}, {2, 4}, {4, 2}, {1, 1}}};
constexpr int max_rows = 4;

/// The entries of eight stencils, one stencil per lane: entry a of lane k is at a·8 + k. Entries come in patches of one
/// shape, whose rows have the same offsets from the lane's base in every lane. A patch contains no node twice. Copied
/// by value into loops, so that the compiler knows that it does not change meanwhile.
template <int Dim>
struct StencilEntries {
  Index* base = nullptr;             ///< nodes, [patches][8]
  double* value = nullptr;           ///< N_ip [-], [count][8]
  double* gradient = nullptr;        ///< ∂N_ip/∂x_d [1/m], [count][Dim][8]
  int count = 0;                     ///< entries in use
  PatchShape shape{1, 1};            ///< of all patches, one of `patch_shapes`
  std::array<Index, max_rows> row{}; ///< offsets of the rows from the base

  void set_base(int patch, const std::array<Index, pack_size>& nodes) const {
    std::copy(nodes.begin(), nodes.end(), base + patch * pack_size);
  }
  void set_value(int entry, const Pack& N) const { N.store(value + entry * pack_size); }
  void set_gradient(int entry, int axis, const Pack& dN) const {
    dN.store(gradient + (entry * Dim + axis) * pack_size);
  }

  [[nodiscard]] Index node_of(int entry, Index lane) const {
    const int patch = entry / shape.entries(), r = entry / shape.length % shape.rows;
    return base[patch * pack_size + lane] + row[r] + entry % shape.length;
  }
  [[nodiscard]] double value_of(int entry, Index lane) const { return value[entry * pack_size + lane]; }
  [[nodiscard]] double gradient_of(int entry, int axis, Index lane) const {
    return gradient[(entry * Dim + axis) * pack_size + lane];
  }
};

/// The stencils of eight consecutive points; a node may appear in more than one patch of a point.
template <int Dim>
struct StencilGroup : StencilEntries<Dim> {
  std::array<Index, pack_size> lowest{}; ///< lowest and highest index of each lane's nodes along the last axis
  std::array<Index, pack_size> highest{};
  std::array<bool, pack_size> lost{}; ///< this lane's support leaves the grid; its weights are zero

  /// Marks the lanes that are not in `inside` as lost and zeroes their weights, so that these may be used without
  /// checking the flags. The bases must be such that all nodes are on the grid.
  void keep_lanes(const Mask& inside) {
    lost.fill(false);
    if (all(inside)) return;
    const std::array<bool, pack_size> kept = lanes(inside);
    for (int k = 0; k < pack_size; ++k) {
      lost[k] = !kept[k];
      if (kept[k]) continue;
      for (int i = k; i < this->count * pack_size; i += pack_size) this->value[i] = 0;
      for (int i = k; i < this->count * Dim * pack_size; i += pack_size) this->gradient[i] = 0;
    }
  }
};

template <int Dim>
class Stencils {
public:
  /// Allocates the stencils of `points` points.
  void resize(Index points, int max_nodes) {
    const std::size_t groups = static_cast<std::size_t>((points + pack_size - 1) / pack_size);
    const std::size_t entries = groups * static_cast<std::size_t>(max_nodes * pack_size);
    base_.assign(entries, 0);
    value_.assign(entries, 0.0);
    gradient_.assign(entries * Dim, 0.0);
    groups_.assign(groups, {});
    for (std::size_t g = 0; g < groups; ++g) {
      const std::size_t at = g * static_cast<std::size_t>(max_nodes * pack_size);
      groups_[g].base = base_.data() + at;
      groups_[g].value = value_.data() + at;
      groups_[g].gradient = gradient_.data() + at * Dim;
    }
  }
  [[nodiscard]] Index size() const { return static_cast<Index>(groups_.size()) * pack_size; } ///< points, rounded up
  const Columns* node_data = nullptr; ///< nodal results of the scheme's pre-pass; null without one

  /// Sets the first group to that of `first`, a multiple of eight.
  void begin_at(Index first) { first_ = first / pack_size; }
  /// The group of point p; p's lane in it is p mod 8.
  [[nodiscard]] StencilGroup<Dim>& group_of(Index p) {
    return groups_[static_cast<std::size_t>(p / pack_size - first_)];
  }
  [[nodiscard]] const StencilGroup<Dim>& group_of(Index p) const {
    return groups_[static_cast<std::size_t>(p / pack_size - first_)];
  }

private:
  Index first_ = 0; ///< number of groups before the first one stored
  std::vector<StencilGroup<Dim>> groups_;
  AlignedVector<Index> base_;
  AlignedVector<double> value_, gradient_;
};

} // namespace riedel
