#include "apps/verify/block.hpp"

#include "core/step/musl.hpp"

#include <chrono>

namespace riedel {

namespace {

void place_points(Points<2>& points, const VerifyBlock& block, const Material& law) {
  constexpr int per_cell = 2;
  const double spacing = block.cell / per_cell;
  std::vector<Vec<2>> places;
  for (Index j = 0; j < block.cells[1] * per_cell; ++j)
    for (Index i = 0; i < block.cells[0] * per_cell; ++i) {
      const Vec<2> x((i + 0.5) * spacing, (j + 0.5) * spacing);
      if (block.holds == nullptr || block.holds(x)) places.push_back(x);
    }
  points.resize(static_cast<Index>(places.size()), state_components(law.states()));
  const std::vector<double> fresh(static_cast<std::size_t>(points.state.components()));
  for (Index p = 0; p < points.size(); ++p) {
    for (int a : {0, 1}) {
      points.position[a][p] = places[static_cast<std::size_t>(p)][a];
      points.half_size[a][p] = 0.5 * spacing;
    }
    points.volume[0][p] = points.initial_volume[0][p] = square(spacing);
    points.mass[0][p] = law.density(fresh) * square(spacing);
  }
}

} // namespace

std::vector<Vec<2>> VerifySetup::places() const {
  const Points<2>& points = state.bodies.front().points;
  std::vector<Vec<2>> X(static_cast<std::size_t>(points.size()));
  for (Index p = 0; p < points.size(); ++p)
    X[static_cast<std::size_t>(points.id[static_cast<std::size_t>(p)])] = points.position_of(p);
  return X;
}

void VerifySetup::add_roller(int axis, bool far_side) {
  const auto a = static_cast<std::size_t>(axis);
  NodeCondition<2> roller{.name = (far_side ? "far side " : "near side ") + std::to_string(axis),
                          .last = {state.grid.nodes[0] - 1, state.grid.nodes[1] - 1},
                          .axis = axis,
                          .velocity = [](double) { return 0.0; }};
  if (far_side)
    roller.first[a] = state.grid.nodes[a] - 1 - margin;
  else
    roller.last[a] = margin;
  model.conditions.push_back(std::move(roller));
}

Index VerifySetup::divide(double duration, double speed, double cfl) {
  const auto steps = static_cast<Index>(std::ceil(duration * speed / (cfl * state.grid.cell.minCoeff())));
  model.fixed_time_step = duration / steps;
  return steps;
}

VerifySetup make_setup(const Catalogue& catalogue, const std::string& scheme, const VerifyBlock& block) {
  VerifySetup setup;
  const auto& chosen = catalogue.in_2d.schemes.find(scheme);
  setup.model.scheme = chosen.make(Values(chosen.description.parameters));
  setup.model.step = musl_step<2>;
  setup.model.flip = 1.0;
  setup.margin = setup.model.scheme->margin() + 2;

  Grid<2>& grid = setup.state.grid;
  grid.cell.setConstant(block.cell);
  grid.origin.setConstant(-setup.margin * block.cell);
  for (std::size_t a : {0, 1}) grid.nodes[a] = block.cells[a] + 2 * setup.margin + 1;

  const auto& law = catalogue.materials.find(block.material);
  Values values(law.description.parameters);
  for (const auto& [key, value] : block.parameters) values.set(key, value);
  Body<2>& body = setup.state.bodies.emplace_back();
  body.name = "block";
  body.material = law.make(values);
  place_points(body.points, block, *body.material);
  return setup;
}

void Watch::step(Simulation<2>& simulation) {
  const auto start = std::chrono::steady_clock::now();
  simulation.step();
  seconds_ += std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  point_steps_ += simulation.state().bodies.front().points.size();
}

} // namespace riedel
