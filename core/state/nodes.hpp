/// Fields on the nodes of the background grid. What one point's scatter or gather touches at a node is contiguous.
#pragma once

#include "core/base/columns.hpp"
#include "core/base/quad.hpp"

namespace riedel {

/// What the points add up at a node: one cache line, and one pack.
template <int Dim>
struct alignas(64) NodeSums {
  Vec<Dim> momentum = Vec<Dim>::Zero(); ///< (mv)_i
  Vec<Dim> force = Vec<Dim>::Zero();    ///< f_i, external and internal [N or N/m]
  double mass = 0.0;                    ///< m_i [kg, or kg/m in plane strain]
  std::array<double, 7 - 2 * Dim> padding{};

  static constexpr int momentum_at = 0, force_at = Dim, mass_at = 2 * Dim; ///< places in the pack
  void add(const Pack& share) { (Pack::load(momentum.data()) + share).store(momentum.data()); }
};
static_assert(sizeof(NodeSums<2>) == 64 && sizeof(NodeSums<3>) == 64);

/// What a node tells the points: velocity, then acceleration, in a record of four doubles (eight in three dimensions).
template <int Dim>
struct alignas(Dim == 2 ? 32 : 64) NodeMotion {
  Vec<Dim> velocity = Vec<Dim>::Zero();     ///< v_i [m/s]
  Vec<Dim> acceleration = Vec<Dim>::Zero(); ///< (v_i − v_i before the step)/Δt, boundary conditions included [m/s²]

  using Record = std::conditional_t<Dim == 2, Quad, Pack>;
  [[nodiscard]] Record record() const { return Record::load(velocity.data()); }
};

template <int Dim>
struct Nodes {
  AlignedVector<NodeSums<Dim>> sums;
  AlignedVector<NodeMotion<Dim>> motion;

  void resize(Index count) {
    sums.assign(static_cast<std::size_t>(count), {});
    motion.assign(static_cast<std::size_t>(count), {});
  }
  void clear_sums() { std::fill(sums.begin(), sums.end(), NodeSums<Dim>{}); }
  [[nodiscard]] Index size() const { return static_cast<Index>(sums.size()); }
};

} // namespace riedel
