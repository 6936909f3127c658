/// The stencils of one body, handed out block by block.
#pragma once

#include "core/base/phase_clock.hpp"
#include "core/interface/shape_function.hpp"

#include <optional>

namespace riedel {

/// Points whose stencils are evaluated at once and consumed while they are in the processor's nearest cache.
constexpr Index stencil_block = 32;

/// Either evaluates a block's stencils each time they are asked for, into a buffer of the thread that asks, or keeps
/// those of all points for a step. Both give the same bits; which is faster, and by how much, stands in
/// docs/benchmarks.md.
template <int Dim>
class StencilBlocks {
public:
  /// @param points to make room for   @param keep whether to keep all; empty: if they take little room
  void resize(Index points, int max_nodes, std::optional<bool> keep);
  [[nodiscard]] bool keeps() const { return keeps_; }

  /// At the start of a step: the scheme's pre-pass, room for each thread, and all stencils if they are kept.
  void begin_step(const ShapeFunction<Dim>& scheme, const Grid<Dim>& grid, const Points<Dim>& points,
                  PhaseClock& clock);
  /// For work that asks for them many times: all stencils are kept until the next step begins.
  void keep_for_this_step(const ShapeFunction<Dim>& scheme, const Grid<Dim>& grid, const Points<Dim>& points,
                          PhaseClock& clock);

  /// Of the points in `block`, at most `stencil_block`, the first number a multiple of eight.
  const Stencils<Dim>& of(const ShapeFunction<Dim>& scheme, const Grid<Dim>& grid, const Points<Dim>& points,
                          Range block, PhaseClock& clock);

private:
  bool always_keeps_ = false;
  bool keeps_ = false; ///< in this step
  int max_nodes_ = 0;
  Columns node_data_{0}; ///< of the scheme's pre-pass
  Stencils<Dim> kept_;
  std::vector<Stencils<Dim>> buffers_; ///< one for each thread
};

} // namespace riedel
