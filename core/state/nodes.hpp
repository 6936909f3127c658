/// Fields on the nodes of the background grid. What scatter or gather of one point touches at a node is contiguous.
#pragma once

#include "core/base/columns.hpp"
#include "core/base/short_vector.hpp"

namespace riedel {

/// Space for a vector in a node's records: a number of doubles that processors load at once.
template <int Dim>
using VectorLanes = ShortVector<Dim == 2 ? 2 : 4>;

/// Sums over the points at a node: one cache line.
template <int Dim>
struct alignas(64) NodeSums {
  Vec<Dim> momentum = Vec<Dim>::Zero();          ///< (mv)_i
  double mass = 0.0;                             ///< m_i [kg, or kg/m in plane strain]
  alignas(32) Vec<Dim> force = Vec<Dim>::Zero(); ///< f_i of stresses and surface loads [N or N/m]

  using MassRecord = ShortVector<4>; ///< momentum, then mass
  using ForceRecord = VectorLanes<Dim>;
  static constexpr int mass_at = Dim; ///< place in the first record
};
static_assert(sizeof(NodeSums<2>) == 64 && sizeof(NodeSums<3>) == 64);

/// What the points read from a node, in a record of four doubles (eight in three dimensions).
template <int Dim>
struct alignas(Dim == 2 ? 32 : 64) NodeMotion {
  Vec<Dim> velocity = Vec<Dim>::Zero(); ///< v_i [m/s]
  /// (v_i − v_i before the step)/Δt, boundary conditions included [m/s²]
  alignas(sizeof(VectorLanes<Dim>)) Vec<Dim> acceleration = Vec<Dim>::Zero();

  using Record = ShortVector<Dim == 2 ? 4 : 8>;
};
static_assert(sizeof(NodeMotion<2>) == 32 && sizeof(NodeMotion<3>) == 64);

/// Nodal sums of the points' fields during smoothing, eight numbers per node; empty without a filter.
struct SmoothingNodes {
  AlignedVector<ShortVector<8>> sum;   ///< Σ_p N_ip V_p a_p
  AlignedVector<ShortVector<8>> term;  ///< the last term of a series
  AlignedVector<ShortVector<8>> total; ///< the series so far
  AlignedVector<double> per_volume;    ///< 1/Σ_p N_ip V_p, 0 if no point is near [1/m³ or 1/m²]

  void resize(Index count) {
    for (AlignedVector<ShortVector<8>>* rows : {&sum, &term, &total})
      rows->assign(static_cast<std::size_t>(count), ShortVector<8>(0.0));
    per_volume.assign(static_cast<std::size_t>(count), 0.0);
  }
};

/// Power of all forces on the nodes, Σ_i m_i a_i·v_i [W or W/m].
struct NodePower {
  double start = 0.0; ///< with the velocities from which the previous strains were computed
  double end = 0.0;   ///< with those from which the next strains are computed
};

template <int Dim>
struct Nodes {
  AlignedVector<NodeSums<Dim>> sums;
  AlignedVector<NodeMotion<Dim>> motion;
  SmoothingNodes smoothing; ///< working space of the stress filter, empty without it

  void resize(Index count) {
    sums.assign(static_cast<std::size_t>(count), {});
    motion.assign(static_cast<std::size_t>(count), {});
  }
  void clear_sums() { std::fill(sums.begin(), sums.end(), NodeSums<Dim>{}); }
  [[nodiscard]] Index size() const { return static_cast<Index>(sums.size()); }
};

} // namespace riedel
