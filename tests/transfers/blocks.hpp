/// Blocks of points for the contract of the transfers.
#pragma once

#include "core/step/orders.hpp"
#include "support/problems.hpp"

namespace riedel::test {

template <int Dim>
using TransferPointer = std::shared_ptr<const VelocityTransfer<Dim>>;

constexpr double cell = 0.05, soft_density = 1000.0;

/// Points anywhere near a lattice, with the given stiffness [Pa], at rest.
template <int Dim>
State<Dim> scattered_block(Counts<Dim> cells, double stiffness) {
  State<Dim> state =
      elastic_state<Dim>(cells, cell, 2, 5, [](const Vec<Dim>&) { return true; },
                         {{"youngs_modulus", stiffness}, {"poissons_ratio", 0.3}, {"density", soft_density}});
  std::mt19937 random(7);
  std::uniform_real_distribution<double> between(-0.1 * cell, 0.1 * cell);
  Points<Dim>& points = state.bodies[0].points;
  for (Index p = 0; p < points.size(); ++p)
    for (int a = 0; a < Dim; ++a) points.position[a][p] += between(random);
  return state;
}

template <int Dim>
void shake(Points<Dim>& points) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> between(-1.0, 1.0);
  for (Index p = 0; p < points.size(); ++p)
    for (int a = 0; a < Dim; ++a) points.velocity[a][p] = between(random);
}

template <int Dim>
Model<Dim> model_of(const std::string& scheme_name, TransferPointer<Dim> chosen, StepFunction<Dim> step) {
  Model<Dim> model = model_with<Dim>(scheme_name);
  model.step = step;
  model.transfer = std::move(chosen);
  return model;
}

template <int Dim>
Counts<Dim> some_cells(Index along) {
  Counts<Dim> cells;
  cells.fill(2);
  cells[0] = along;
  return cells;
}

} // namespace riedel::test
