#include "apps/verify/block.hpp"

#include "apps/riedel.hpp"
#include "core/setup/fill.hpp"
#include "core/step/boundaries/prescribed_velocity.hpp"
#include "core/step/musl.hpp"

namespace riedel {

namespace {

template <int Dim>
void place_points(Points<Dim>& points, const VerifyBlock<Dim>& block, int per_cell, const Material& law) {
  Lattice<Dim> lattice{.spacing = block.cell / per_cell * block.filled, .count = block.cells};
  for (Index& n : lattice.count) n *= per_cell;
  fill<Dim>(points, lattice, state_components(law.states()), block.holds);
  const double density = law.density(std::vector<double>(static_cast<std::size_t>(points.state.components())));
  for (Index p = 0; p < points.size(); ++p) points.mass[0][p] = density * points.volume[0][p];
}

} // namespace

template <int Dim>
std::vector<Vec<Dim>> VerifySetup<Dim>::places() const {
  std::vector<Vec<Dim>> X(static_cast<std::size_t>(points().size()));
  for (Index p = 0; p < points().size(); ++p)
    X[static_cast<std::size_t>(points().id[static_cast<std::size_t>(p)])] = points().position_of(p);
  return X;
}

template <int Dim>
void VerifySetup<Dim>::set_velocity(const VectorField<Dim>& velocity) {
  for (Index p = 0; p < points().size(); ++p) {
    const Vec<Dim> v = velocity(points().position_of(p));
    for (int a = 0; a < Dim; ++a) points().velocity[a][p] = v[a];
  }
}

template <int Dim>
void VerifySetup<Dim>::add_body_force(const Course<Dim>& per_mass) {
  model.body_forces.push_back({.per_mass = [X = places(), per_mass](const Points<Dim>& points, Index p, double time) {
    return per_mass(start_of(points, p, X), time);
  }});
}

template <int Dim>
void VerifySetup<Dim>::add_roller(const Side& side) {
  const auto a = static_cast<std::size_t>(side.axis);
  VelocityOnNodes<Dim> roller{.name = (side.far ? "far side " : "near side ") + std::to_string(side.axis),
                              .axis = side.axis,
                              .velocity = [](double) { return 0.0; }};
  for (std::size_t b = 0; b < Dim; ++b) roller.last[b] = state.grid.nodes[b] - 1;
  if (side.far)
    roller.first[a] = state.grid.nodes[a] - 1 - margin;
  else
    roller.last[a] = margin;
  model.conditions.push_back(prescribe(std::move(roller)));
}

template <int Dim>
Index VerifySetup<Dim>::divide(double duration, double speed, double cfl) {
  const auto steps = static_cast<Index>(std::ceil(duration * speed / (cfl * state.grid.cell.minCoeff())));
  model.fixed_time_step = duration / steps;
  return steps;
}

template <int Dim>
VerifySetup<Dim> make_setup(const VerifyCase& given, const VerifyBlock<Dim>& block) {
  VerifySetup<Dim> setup;
  const auto& chosen = given.catalogue.in<Dim>().schemes.find(given.scheme);
  setup.model.scheme = chosen.make(Values(chosen.description.parameters));
  setup.model.step = musl_step<Dim>;
  setup.model.transfer = make(given.catalogue.in<Dim>().transfers, "flip", {{"flip", 1.0}});
  setup.margin = setup.model.scheme->margin() + 2;

  Grid<Dim>& grid = setup.state.grid;
  grid.cell.setConstant(block.cell);
  grid.origin.setConstant(-setup.margin * block.cell);
  for (std::size_t a = 0; a < Dim; ++a) grid.nodes[a] = block.cells[a] + 2 * setup.margin + 1;

  const auto& law = given.catalogue.materials.find(block.material);
  Values values(law.description.parameters);
  for (const auto& [key, value] : block.parameters) values.set(key, value);
  Body<Dim>& body = setup.state.bodies.emplace_back();
  body.name = "block";
  body.material = law.make(values);
  place_points(body.points, block, given.points > 0 ? given.points : block.points, *body.material);
  return setup;
}

template struct VerifySetup<2>;
template struct VerifySetup<3>;
template VerifySetup<2> make_setup<2>(const VerifyCase&, const VerifyBlock<2>&);
template VerifySetup<3> make_setup<3>(const VerifyCase&, const VerifyBlock<3>&);

} // namespace riedel
