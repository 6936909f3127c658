#include "core/step/boundaries/node_box.hpp"

namespace riedel {

template <int Dim>
std::vector<Index> nodes_in(const Grid<Dim>& grid, const NodeBox<Dim>& box) {
  std::vector<Index> nodes;
  for (Index i = 0; i < grid.node_count(); ++i)
    if (within_box<Dim>(grid.index(i), box.first, box.last)) nodes.push_back(i);
  return nodes;
}

template <int Dim>
std::array<Walls, Dim> walls_of(const Grid<Dim>& grid, const NodeBox<Dim>& box) {
  std::array<Walls, Dim> walls{};
  for (int a = 0; a < Dim; ++a)
    if (a != box.axis && (box.first[a] > 0 || box.last[a] < grid.nodes[a] - 1)) return walls;
  Walls& wall = walls[box.axis];
  const bool from_below = box.first[box.axis] <= 0, from_above = box.last[box.axis] >= grid.nodes[box.axis] - 1;
  if (from_below && !from_above) wall.first = box.last[box.axis];
  if (from_above && !from_below) wall.last = box.first[box.axis];
  return walls;
}

template std::vector<Index> nodes_in<2>(const Grid<2>&, const NodeBox<2>&);
template std::vector<Index> nodes_in<3>(const Grid<3>&, const NodeBox<3>&);
template std::array<Walls, 2> walls_of<2>(const Grid<2>&, const NodeBox<2>&);
template std::array<Walls, 3> walls_of<3>(const Grid<3>&, const NodeBox<3>&);

} // namespace riedel
