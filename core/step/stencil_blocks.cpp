#include "core/step/stencil_blocks.hpp"

#include "core/base/parallel.hpp"

namespace riedel {

template <int Dim>
void StencilBlocks<Dim>::resize(Index points, int max_nodes, bool keep) {
  keeps_ = keep;
  max_nodes_ = max_nodes;
  buffers_.clear();
  kept_.resize(keep ? points : 0, max_nodes);
}

template <int Dim>
void StencilBlocks<Dim>::begin_step(const ShapeFunction<Dim>& scheme, const Grid<Dim>& grid, const Points<Dim>& points,
                                    PhaseClock& clock) {
  if (keeps_) {
    const PhaseClock::Lap lap(clock, Phase::stencils);
    for_each_block(points.size(), [&](Range block) { scheme.evaluate(grid, points, block, kept_); });
  } else {
    while (buffers_.size() < static_cast<std::size_t>(most_threads()))
      buffers_.emplace_back().resize(stencil_block, max_nodes_);
  }
}

template <int Dim>
const Stencils<Dim>& StencilBlocks<Dim>::of(const ShapeFunction<Dim>& scheme, const Grid<Dim>& grid,
                                            const Points<Dim>& points, Range block, PhaseClock& clock) {
  if (keeps_) return kept_;
  const PhaseClock::Lap lap(clock, Phase::stencils);
  Stencils<Dim>& buffer = buffers_[static_cast<std::size_t>(this_thread())];
  buffer.begin_at(block.begin);
  scheme.evaluate(grid, points, block, buffer);
  return buffer;
}

template class StencilBlocks<2>;
template class StencilBlocks<3>;

} // namespace riedel
