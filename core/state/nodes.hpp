/// Fields on the nodes of the background grid. What one point's scatter or gather touches at a node is contiguous.
#pragma once

#include "core/base/columns.hpp"

namespace riedel {

/// What the points add up at a node; one cache line.
template <int Dim>
struct alignas(64) NodeSums {
  double mass = 0.0;                    ///< m_i [kg, or kg/m in plane strain]
  Vec<Dim> momentum = Vec<Dim>::Zero(); ///< (mv)_i
  Vec<Dim> force = Vec<Dim>::Zero();    ///< f_i, external and internal [N or N/m]
};

/// What a node tells the points.
template <int Dim>
struct NodeMotion {
  Vec<Dim> velocity = Vec<Dim>::Zero();     ///< v_i [m/s]
  Vec<Dim> acceleration = Vec<Dim>::Zero(); ///< (v_i − v_i before the step)/Δt, boundary conditions included [m/s²]
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
