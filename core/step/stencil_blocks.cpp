#include "core/step/stencil_blocks.hpp"

#include "core/base/parallel.hpp"

namespace riedel {

namespace {
constexpr std::int64_t little = 3 << 20; ///< size up to which keeping was measured to be faster [bytes]

template <int Dim>
bool take_little_room(Index points, int max_nodes) {
  return std::int64_t{points} * max_nodes * std::int64_t{(1 + Dim) * sizeof(double) + sizeof(Index)} <= little;
}
} // namespace

template <int Dim>
void StencilBlocks<Dim>::resize(Index points, int max_nodes, std::optional<bool> keep) {
  keeps_ = always_keeps_ = keep.value_or(take_little_room<Dim>(points, max_nodes));
  max_nodes_ = max_nodes;
  buffers_.clear();
  kept_.resize(keeps_ ? points : 0, max_nodes);
}

template <int Dim>
void StencilBlocks<Dim>::begin_step(const ShapeFunction<Dim>& scheme, const Grid<Dim>& grid, const Points<Dim>& points,
                                    PhaseClock& clock) {
  keeps_ = always_keeps_;
  if (!keeps_)
    while (buffers_.size() < static_cast<std::size_t>(max_threads()))
      buffers_.emplace_back().resize(stencil_block, max_nodes_);
  const PhaseClock::Lap lap(clock, Phase::stencils);
  if (scheme.node_data_size() > 0) {
    if (node_data_.components() != scheme.node_data_size()) node_data_ = Columns(scheme.node_data_size());
    if (node_data_.size() != grid.node_count()) node_data_.resize(grid.node_count());
    scheme.prepare(grid, points, node_data_);
    kept_.node_data = &node_data_;
    for (Stencils<Dim>& buffer : buffers_) buffer.node_data = &node_data_;
  }
  if (keeps_) for_each_block(points.size(), [&](Range block) { scheme.evaluate(grid, points, block, kept_); });
}

template <int Dim>
void StencilBlocks<Dim>::keep_for_this_step(const ShapeFunction<Dim>& scheme, const Grid<Dim>& grid,
                                            const Points<Dim>& points, PhaseClock& clock) {
  if (keeps_) return;
  const PhaseClock::Lap lap(clock, Phase::stencils);
  if (kept_.size() < points.size()) kept_.resize(points.size(), max_nodes_);
  for_each_block(points.size(), [&](Range block) { scheme.evaluate(grid, points, block, kept_); });
  keeps_ = true;
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
