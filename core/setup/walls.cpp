#include "core/setup/walls.hpp"

#include "core/base/error.hpp"
#include "core/base/parameters.hpp"
#include "core/step/boundaries/friction_wall.hpp"

#include <cmath>

namespace riedel {

namespace {

/// Index of the row of nodes at that position.
template <int Dim>
Index row_at(const Grid<Dim>& grid, const std::string& wall, int axis, double place) {
  const double rows = (place - grid.origin[axis]) / grid.cell[axis], row = std::round(rows);
  const double last = grid.nodes[static_cast<std::size_t>(axis)] - 1;
  if (std::abs(rows - row) <= 1e-6 && row >= 0.0 && row <= last) return static_cast<Index>(row);
  const auto line = [&](double number) {
    return exact_text(grid.origin[axis] + std::clamp(number, 0.0, last) * grid.cell[axis]) + " m";
  };
  throw InputError("wall '" + wall + "' at " + exact_text(place) + " m along axis " + std::to_string(axis) +
                   " is not on a grid line; the lines beside it are at " + line(std::floor(rows)) + " and " +
                   line(std::ceil(rows)));
}

/// Fixes the nodes of the box along `axis`.
template <int Dim>
Boundary<Dim> fixed(std::string name, const NodeBox<Dim>& nodes, int axis) {
  return prescribe<Dim>(
      {.name = std::move(name), .first = nodes.first, .last = nodes.last, .axis = axis, .velocity = [](double) {
         return 0.0;
       }});
}

} // namespace

template <int Dim>
NodeBox<Dim> side(const Grid<Dim>& grid, const std::string& name, int axis, double place, Behind behind) {
  NodeBox<Dim> nodes{.axis = axis, .behind = behind};
  for (std::size_t a = 0; a < Dim; ++a) nodes.last[a] = grid.nodes[a] - 1;
  const Index row = row_at(grid, name, axis, place);
  (behind == Behind::lower ? nodes.last : nodes.first)[static_cast<std::size_t>(axis)] = row;
  return nodes;
}

template <int Dim>
Boundary<Dim> smooth_wall(const Grid<Dim>& grid, std::string name, int axis, double place, Behind behind) {
  const NodeBox<Dim> nodes = side(grid, name, axis, place, behind);
  return fixed(std::move(name), nodes, axis);
}

template <int Dim>
std::vector<Boundary<Dim>> rough_wall(const Grid<Dim>& grid, const std::string& name, int axis, double place,
                                      Behind behind) {
  const NodeBox<Dim> nodes = side(grid, name, axis, place, behind);
  std::vector<Boundary<Dim>> all;
  for (int each = 0; each < Dim; ++each) all.push_back(fixed(name + "_" + "xyz"[each], nodes, each));
  return all;
}

template <int Dim>
Boundary<Dim> friction_wall(const Grid<Dim>& grid, const std::string& name, int axis, double place, Behind behind,
                            double coefficient) {
  return std::make_unique<FrictionWall<Dim>>(
      FrictionOnNodes<Dim>{.name = name, .place = side(grid, name, axis, place, behind), .coefficient = coefficient});
}

template Boundary<2> friction_wall<2>(const Grid<2>&, const std::string&, int, double, Behind, double);
template Boundary<3> friction_wall<3>(const Grid<3>&, const std::string&, int, double, Behind, double);
template NodeBox<2> side<2>(const Grid<2>&, const std::string&, int, double, Behind);
template NodeBox<3> side<3>(const Grid<3>&, const std::string&, int, double, Behind);
template Boundary<2> smooth_wall<2>(const Grid<2>&, std::string, int, double, Behind);
template Boundary<3> smooth_wall<3>(const Grid<3>&, std::string, int, double, Behind);
template std::vector<Boundary<2>> rough_wall<2>(const Grid<2>&, const std::string&, int, double, Behind);
template std::vector<Boundary<3>> rough_wall<3>(const Grid<3>&, const std::string&, int, double, Behind);

} // namespace riedel
