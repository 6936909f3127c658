/// Small problems for tests: blocks of points on a grid, with a scheme and a law taken from the catalogue by name.
#pragma once

#include "core/step/boundaries/prescribed_velocity.hpp"
#include "core/step/musl.hpp"
#include "core/step/simulation.hpp"
#include "support/named.hpp"

#include <random>

namespace riedel::test {

/// Stencils of points that have just been placed.
template <int Dim>
void evaluate_anew(const ShapeFunction<Dim>& scheme, const Grid<Dim>& grid, Points<Dim>& points, Columns& node_data,
                   Stencils<Dim>& stencils) {
  initialise(scheme, grid, points);
  if (scheme.node_data_size() > 0) {
    node_data = Columns(scheme.node_data_size());
    node_data.resize(grid.node_count());
    scheme.prepare(grid, points, node_data);
    stencils.node_data = &node_data;
  }
  scheme.evaluate(grid, points, {0, points.size()}, stencils);
}

/// A grid of `cells` cells of size h around the origin-based box, with `margin` layers of cells on every side.
template <int Dim>
Grid<Dim> grid_of(Counts<Dim> cells, double h, Index margin) {
  Grid<Dim> grid;
  grid.cell.setConstant(h);
  grid.origin.setConstant(-margin * h);
  for (int a = 0; a < Dim; ++a) grid.nodes[a] = cells[a] + 2 * margin + 1;
  return grid;
}

/// Points on a lattice, `per_cell` along each direction of a cell, wherever `inside(x)` holds; unit thickness.
template <int Dim, class Inside>
void fill(Points<Dim>& points, Counts<Dim> cells, double h, Index per_cell, double density, int states,
          const Inside& inside) {
  std::vector<Vec<Dim>> places;
  const double spacing = h / per_cell;
  Counts<Dim> count = cells;
  Index all = 1;
  for (Index& n : count) all *= n *= per_cell;
  for (Index i = 0; i < all; ++i) {
    Vec<Dim> x;
    for (int a = 0, rest = i; a < Dim; rest /= count[a], ++a) x[a] = (rest % count[a] + 0.5) * spacing;
    if (inside(x)) places.push_back(x);
  }
  points.resize(static_cast<Index>(places.size()), states);
  for (Index p = 0; p < points.size(); ++p) {
    for (int a = 0; a < Dim; ++a) {
      points.position[a][p] = places[static_cast<std::size_t>(p)][a];
      points.half_size[a][p] = 0.5 * spacing;
    }
    points.volume[0][p] = points.initial_volume[0][p] = std::pow(spacing, Dim);
    points.mass[0][p] = density * points.volume[0][p];
  }
}

/// An elastic body and the grid around it.
template <int Dim, class Inside>
State<Dim> elastic_state(Counts<Dim> cells, double h, Index per_cell, Index margin, const Inside& inside,
                         std::map<std::string, Value> law = {}) {
  State<Dim> state;
  state.grid = grid_of<Dim>(cells, h, margin);
  Body<Dim>& body = state.bodies.emplace_back();
  body.name = "body";
  body.material = material("linear_elastic", std::move(law));
  fill<Dim>(body.points, cells, h, per_cell, body.material->density({}), 0, inside);
  return state;
}

template <int Dim>
Model<Dim> model_with(const std::string& scheme_name) {
  Model<Dim> model;
  model.scheme = scheme<Dim>(scheme_name);
  model.step = musl_step<Dim>;
  return model;
}

} // namespace riedel::test
