#include "core/setup/fill.hpp"

#include "core/base/error.hpp"

#include <cmath>

namespace riedel {

template <int Dim>
void fill(Points<Dim>& points, const Lattice<Dim>& lattice, int states, const Shape<Dim>& holds) {
  Index boxes = 1;
  for (const Index n : lattice.count) boxes *= n;
  const auto place = [&](Index box) {
    Vec<Dim> x;
    for (int a = 0; a < Dim; box /= lattice.count[static_cast<std::size_t>(a)], ++a)
      x[a] = lattice.corner[a] + (box % lattice.count[static_cast<std::size_t>(a)] + 0.5) * lattice.spacing[a];
    return x;
  };
  std::vector<Index> filled;
  filled.reserve(static_cast<std::size_t>(boxes));
  for (Index box = 0; box < boxes; ++box)
    if (!holds || holds(place(box))) filled.push_back(box);
  points.resize(static_cast<Index>(filled.size()), states);
  for (Index p = 0; p < points.size(); ++p) {
    const Vec<Dim> x = place(filled[static_cast<std::size_t>(p)]);
    for (int a = 0; a < Dim; ++a) {
      points.position[a][p] = x[a];
      points.half_size[a][p] = 0.5 * lattice.spacing[a];
    }
    points.volume[0][p] = points.initial_volume[0][p] = lattice.spacing.prod();
  }
}

template <int Dim>
Grid<Dim> grid_around(const Vec<Dim>& lower, const Vec<Dim>& upper, double cell, Index margin) {
  Grid<Dim> grid;
  grid.cell.setConstant(cell);
  for (int a = 0; a < Dim; ++a) {
    const double cells = (upper[a] - lower[a]) / cell, whole = std::round(cells);
    if (!(cell > 0.0) || !(whole >= 1.0) || std::abs(cells - whole) > 1e-6)
      throw InputError("a grid of cells of " + exact_text(cell) + " m from " + exact_text(lower[a]) + " to " +
                       exact_text(upper[a]) + " m along axis " + std::to_string(a) + " has " + short_text(cells, 6) +
                       " cells; allowed: a whole number");
    grid.origin[a] = lower[a] - margin * cell;
    grid.nodes[static_cast<std::size_t>(a)] = static_cast<Index>(whole) + 2 * margin + 1;
  }
  return grid;
}

template <int Dim>
Body<Dim> make_body(std::string name, std::shared_ptr<const Material> law, const Grid<Dim>& grid, Index per_cell,
                    const Shape<Dim>& holds, std::vector<double> state) {
  if (state.empty()) state = law->initial_state();
  const int declared = state_components(law->states());
  if (static_cast<int>(state.size()) != declared)
    throw InputError("body '" + name + "': its state has " + std::to_string(state.size()) +
                     " numbers, its law declares " + std::to_string(declared));
  Counts<Dim> cells = grid.nodes;
  for (Index& n : cells) --n;
  const Lattice<Dim> lattice = lattice_of<Dim>(cells, grid.cell, per_cell, grid.origin);
  Body<Dim> body;
  fill<Dim>(body.points, lattice, declared, holds);
  if (body.points.size() == 0)
    throw InputError("body '" + name + "': its shape contains no point of the grid, whose points are " +
                     short_text(lattice.spacing.minCoeff()) + " m apart");
  body.name = std::move(name);
  body.material = std::move(law);
  const double density = body.material->density(state);
  for (Index p = 0; p < body.points.size(); ++p) {
    body.points.mass[0][p] = density * body.points.volume[0][p];
    for (int s = 0; s < declared; ++s) body.points.state[s][p] = state[static_cast<std::size_t>(s)];
  }
  return body;
}

template void fill<2>(Points<2>&, const Lattice<2>&, int, const Shape<2>&);
template void fill<3>(Points<3>&, const Lattice<3>&, int, const Shape<3>&);
template Grid<2> grid_around<2>(const Vec<2>&, const Vec<2>&, double, Index);
template Grid<3> grid_around<3>(const Vec<3>&, const Vec<3>&, double, Index);
template Body<2> make_body<2>(std::string, std::shared_ptr<const Material>, const Grid<2>&, Index, const Shape<2>&,
                              std::vector<double>);
template Body<3> make_body<3>(std::string, std::shared_ptr<const Material>, const Grid<3>&, Index, const Shape<3>&,
                              std::vector<double>);

} // namespace riedel
