/// Everything that changes in a run.
#pragma once

#include "core/base/phase_clock.hpp"
#include "core/interface/material.hpp"
#include "core/interface/nonlocal_averager.hpp"
#include "core/interface/velocity_transfer.hpp"
#include "core/state/cell_order.hpp"
#include "core/state/nodes.hpp"
#include "core/step/stencil_blocks.hpp"

#include <functional>
#include <memory>

namespace riedel {

/// Material points of one material.
template <int Dim>
struct Body {
  std::string name;
  std::shared_ptr<const Material> material;
  std::unique_ptr<NonlocalAverager<Dim>> averager; ///< null: local
  int averaged_state = -1;                         ///< column of the state averaged; −1: the rate norm ‖D‖
  Points<Dim> points;
  StencilBlocks<Dim> stencils;
  Slabs slabs;
  Columns displacement_increment{Dim}; ///< Δt Σ N_ip v_i, kept for the points' move at the end of a MUSL step [m]

  SortSpace sort_space;                 ///< working space
  std::vector<char> slab_strays;        ///< working space: whether points of a slab touch rows of other slabs
  AlignedVector<ShortVector<8>> fields; ///< working space of the stress filter: one row per point
};

/// A block's share of the results of the stress update.
struct BlockResult {
  MaterialReport report;
  double work = 0.0; ///< Σ V σ:D Δt [J or J/m]
};

/// Sums of rows of fields over some points, plain and times each coordinate: Σ V_p (1, x, y …) a_p.
template <int Dim>
struct FieldMoments {
  std::array<ShortVector<8>, Dim + 1> fields;
  Eigen::Matrix<double, Dim + 1, Dim + 1> weights; ///< Σ V_p (1, x, y …) ⊗ (1, x, y …)
};

/// Sums over the points of a body in one cell.
struct CellSum {
  double volume = 0.0;    ///< Σ V_p [m³ or m²]
  double expansion = 0.0; ///< Σ V_p tr L_p [m³/s or m²/s]
};

template <int Dim>
struct State {
  double time = 0.0; ///< [s]
  std::int64_t step = 0;
  Grid<Dim> grid;
  Nodes<Dim> nodes;
  std::vector<Body<Dim>> bodies;

  double boundary_work = 0.0; ///< done by boundaries since the start [J or J/m]
  double boundary_loss = 0.0; ///< dissipated between boundaries and material since the start [J or J/m]
  double load_work = 0.0;     ///< done by surface tractions and body forces since the start [J or J/m]
  double internal_work = 0.0; ///< ∫ σ:D dV dt since the start [J or J/m]
  double filter_work = 0.0;   ///< part of it by the stress filter's strains [J or J/m]
  double node_work = 0.0;     ///< ∫ Σ_i m_i a_i·v_i dt since the start: work done on the points [J or J/m]
  NodePower node_power;       ///< in this step
  MaterialReport report;      ///< summed since the start

  std::vector<BlockResult> block_results;       ///< working space
  std::vector<NodePower> node_powers;           ///< working space, by block of nodes
  std::vector<CellSum> cell_sums;               ///< working space of the locking remedy, by cell
  std::vector<FieldMoments<Dim>> field_moments; ///< working space of the stress filter, by block
  std::vector<double> filter_powers;            ///< working space of the stress filter, by block
  TransferRoom<Dim> transfer_room;              ///< working space of the transfer
  PhaseClock clock;                             ///< for `riedel bench`
};

} // namespace riedel
