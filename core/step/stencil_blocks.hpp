/// The stencils of one body, provided block by block.
#pragma once

#include "core/base/phase_clock.hpp"
#include "core/interface/shape_function.hpp"

#include <optional>

namespace riedel {

/// Points whose stencils are evaluated at once and used while they are in the processor's nearest cache.
constexpr Index stencil_block = 32;

/// Either evaluates a block's stencils on each request, into a buffer of the requesting thread, or keeps those of all
/// points for a step. Both give results identical to the bit; docs/benchmarks.md compares their speed.
template <int Dim>
class StencilBlocks {
public:
  /// @param points to allocate for @param keep whether to keep all; empty: if they are small
  void resize(Index points, int max_nodes, std::optional<bool> keep);
  [[nodiscard]] bool keeps() const { return keeps_; }

  /// At the start of a step: the scheme's pre-pass, buffers for each thread, and all stencils if they are kept.
  void begin_step(const ShapeFunction<Dim>& scheme, const Grid<Dim>& grid, const Points<Dim>& points,
                  PhaseClock& clock);
  /// For work that requests them many times: all stencils are kept until the next step begins.
  void keep_for_this_step(const ShapeFunction<Dim>& scheme, const Grid<Dim>& grid, const Points<Dim>& points,
                          PhaseClock& clock);

  /// Stencils of the points in `block`, at most `stencil_block`, whose first index is a multiple of eight.
  const Stencils<Dim>& of(const ShapeFunction<Dim>& scheme, const Grid<Dim>& grid, const Points<Dim>& points,
                          Range block, PhaseClock& clock);

private:
  bool always_keeps_ = false;
  bool keeps_ = false; ///< in this step
  int max_nodes_ = 0;
  Columns node_data_{0}; ///< of the scheme's pre-pass
  Stencils<Dim> kept_;
  std::vector<Stencils<Dim>> buffers_; ///< one per thread
};

} // namespace riedel
