#include "core/step/boundary.hpp"

namespace riedel {

template <int Dim>
void bind_boundaries(State<Dim>& state, const Model<Dim>& model) {
  state.grid.walls = {};
  for (const Boundary<Dim>& condition : model.conditions) {
    condition->bind(state.grid, *model.scheme);
    const std::array<Walls, Dim> walls = condition->walls(state.grid);
    for (std::size_t a = 0; a < Dim; ++a) {
      state.grid.walls[a].first = std::max(state.grid.walls[a].first, walls[a].first);
      state.grid.walls[a].last = std::min(state.grid.walls[a].last, walls[a].last);
    }
  }
}

template <int Dim>
void follow_boundaries(const State<Dim>& state, const Model<Dim>& model) {
  for (const Boundary<Dim>& condition : model.conditions) condition->follow(state.grid, *model.scheme);
}

template <int Dim>
void remember_velocities(const State<Dim>& state, const Model<Dim>& model) {
  for (const Boundary<Dim>& condition : model.conditions) condition->remember(state.nodes);
}

template <int Dim>
void apply_boundaries(State<Dim>& state, const Model<Dim>& model, double dt) {
  BoundaryStep<Dim> step{state.grid, state.nodes, state.node_power, state.time + dt, dt};
  for (const Boundary<Dim>& condition : model.conditions) {
    condition->apply(step);
    state.boundary_work += condition->report().work;
    state.boundary_loss += condition->report().dissipated;
  }
}

template <int Dim>
void apply_boundary_velocities(State<Dim>& state, const Model<Dim>& model, double time) {
  BoundaryStep<Dim> step{state.grid, state.nodes, state.node_power, time};
  for (const Boundary<Dim>& condition : model.conditions) condition->apply_velocities(step);
}

template <int Dim>
void move_boundaries(const Model<Dim>& model, double time, double dt) {
  for (const Boundary<Dim>& condition : model.conditions) condition->move(time, dt);
}

template void bind_boundaries<2>(State<2>&, const Model<2>&);
template void bind_boundaries<3>(State<3>&, const Model<3>&);
template void follow_boundaries<2>(const State<2>&, const Model<2>&);
template void follow_boundaries<3>(const State<3>&, const Model<3>&);
template void remember_velocities<2>(const State<2>&, const Model<2>&);
template void remember_velocities<3>(const State<3>&, const Model<3>&);
template void apply_boundaries<2>(State<2>&, const Model<2>&, double);
template void apply_boundaries<3>(State<3>&, const Model<3>&, double);
template void apply_boundary_velocities<2>(State<2>&, const Model<2>&, double);
template void apply_boundary_velocities<3>(State<3>&, const Model<3>&, double);
template void move_boundaries<2>(const Model<2>&, double, double);
template void move_boundaries<3>(const Model<3>&, double, double);

} // namespace riedel
