#include "apps/biaxial/edge_balance.hpp"

#include "apps/biaxial/specimen.hpp"
#include "core/base/parallel.hpp"
#include "core/step/loads.hpp"
#include "core/step/locate.hpp"

namespace riedel {

double imbalance_at_start(const BiaxialCase& values, const Catalogue& catalogue) {
  constexpr Index cells = 8;  // supports at the two sides do not meet
  const ThreadLimit limit(1); // too small to share
  BiaxialCase few = values;
  few.grid.cells = {cells, cells};
  few.grid.dimensions = 2; // weights over the depth are a common factor of all forces
  few.loading.platen = BiaxialCase::Platen::moving_grid;
  few.loading.gravity = 0.0;
  few.nonlocal.length = 0.0;
  Simulation<2> simulation = make_biaxial<2>(few, catalogue);
  State<2>& state = simulation.state();
  locate_points(state, simulation.model());
  simulation.model().transfer->points_to_grid(state, simulation.model());
  add_loads(state, simulation.model());

  const Walls& platens = state.grid.walls[1];
  const double unit = few.loading.confining_pressure * state.grid.cell[1];
  double maximum = 0.0;
  for (Index i = 0; i < state.nodes.size(); ++i) {
    const Index row = state.grid.index(i)[1];
    const bool free = row > platens.first && row < platens.last; // to move up and down
    const Vec<2>& force = state.nodes.sums[i].force;
    maximum = std::max({maximum, std::abs(force[0]) / unit, free ? std::abs(force[1]) / unit : 0.0});
  }
  return maximum;
}

} // namespace riedel
