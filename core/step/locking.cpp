#include "core/step/locking.hpp"

#include "core/base/parallel.hpp"
#include "core/step/kernels/point_motion.hpp"

namespace riedel {

namespace {

/// Σ V_p and Σ V_p tr L_p of each cell, slabs of even number first, then the odd ones: see core/state/cell_order.hpp.
/// Weights that are positive and exact for linear fields touch rows of nodes on both sides of their point, so a point's
/// cell, like its nodes, is used by its slab only.
template <int Dim>
void add_up(const Body<Dim>& body, std::vector<CellSum>& sums) {
  const Points<Dim>& points = body.points;
  const auto add_slab = [&](Index s) {
    const Range slab = body.slabs.range(s);
    for (Index p = slab.begin; p < slab.end; ++p) {
      double trace = 0.0;
      for (int a = 0; a < Dim; ++a) trace += points.velocity_gradient[a * Dim + a][p];
      CellSum& sum = sums[body.sort_space.cell[p]];
      sum.volume += points.volume[0][p];
      sum.expansion += points.volume[0][p] * trace;
    }
  };
  for (Index parity = 0; parity < 2; ++parity)
    parallel_for_unequal((body.slabs.count() - parity + 1) / 2, [&](Index s) { add_slab(2 * s + parity); });
}

/// ⟨tr L⟩ of the cells of eight points; zero past the last point.
template <int Dim>
Pack mean_dilatation(const Body<Dim>& body, const std::vector<CellSum>& sums, Index p) {
  alignas(64) std::array<double, pack_size> mean{};
  for (Index k = 0; k < std::min(Index{pack_size}, body.points.size() - p); ++k) {
    const CellSum& sum = sums[body.sort_space.cell[p + k]];
    mean[k] = sum.expansion / sum.volume;
  }
  return Pack::load(mean.data());
}

/// The third axis of plane strain is left out, or the law would see a strain out of the plane: hence 1/Dim.
template <int Dim>
void dilate(Points<Dim>& points, Index p, const Pack& mean, const StressFilter& filter, double dt) {
  PackMatrix<Dim> L;
  Pack trace(0.0);
  for (int i = 0; i < Dim; ++i) {
    for (int j = 0; j < Dim; ++j) L[i][j] = Pack::load(points.velocity_gradient[i * Dim + j] + p);
    trace += L[i][i];
  }
  const Pack change = Pack(1.0 / Dim) * (mean - trace);
  for (int i = 0; i < Dim; ++i) L[i][i] += change;
  add_expansion<Dim>(points, p, filter, L); // differs between the points of a cell
  for (int i = 0; i < Dim; ++i) L[i][i].store(points.velocity_gradient[i * Dim + i] + p);
  strain(L, points, p, dt);
}

} // namespace

template <int Dim>
void find_cells(State<Dim>& state, const Model<Dim>& model) {
  if (model.locking == Locking::none) return;
  const PhaseClock::Lap lap(state.clock, Phase::kinematics);
  for (Body<Dim>& body : state.bodies) find_cells(state.grid, body.points, body.sort_space);
}

template <int Dim>
void average_dilatation(State<Dim>& state, const Model<Dim>& model, double dt) {
  if (model.locking == Locking::none) return;
  const PhaseClock::Lap lap(state.clock, Phase::kinematics);
  for (Body<Dim>& body : state.bodies) {
    state.cell_sums.resize(static_cast<std::size_t>(state.grid.node_count()));
    parallel_for(state.grid.node_count(), [&](Index cell) { state.cell_sums[cell] = CellSum{}; });
    add_up(body, state.cell_sums);
    for_each_block(body.points.size(), [&](Range block) {
      for (Index p = block.begin; p < block.end; p += pack_size)
        dilate(body.points, p, mean_dilatation(body, state.cell_sums, p), model.stress_filter, dt);
    });
  }
}

template void find_cells<2>(State<2>&, const Model<2>&);
template void find_cells<3>(State<3>&, const Model<3>&);
template void average_dilatation<2>(State<2>&, const Model<2>&, double);
template void average_dilatation<3>(State<3>&, const Model<3>&, double);

} // namespace riedel
