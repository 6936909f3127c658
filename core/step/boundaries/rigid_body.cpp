#include "core/step/boundaries/rigid_body.hpp"

#include <algorithm>

namespace riedel {

namespace {

void drop_repeated(std::vector<Index>& nodes) {
  std::sort(nodes.begin(), nodes.end());
  nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
}

/// One point per cell, the first axis fastest.
template <int Dim>
void fill(Points<Dim>& points, const Grid<Dim>& grid, const NodeBox<Dim>& cells, const std::string& name) {
  Index all = 1;
  for (std::size_t a = 0; a < Dim; ++a) all *= std::max<Index>(cells.last[a] - cells.first[a], 0);
  if (all == 0) throw InputError("rigid body '" + name + "': its box of nodes holds no cell");
  points.resize(all, 0);
  for (Index p = 0; p < all; ++p)
    for (int a = 0, rest = p; a < Dim; ++a) {
      const Index count = cells.last[a] - cells.first[a];
      points.position[a][p] = grid.origin[a] + (cells.first[a] + rest % count + 0.5) * grid.cell[a];
      points.half_size[a][p] = 0.5 * grid.cell[a];
      rest /= count;
    }
  for (Index p = 0; p < all; ++p) points.volume[0][p] = points.initial_volume[0][p] = grid.cell.prod();
}

} // namespace

template <int Dim>
Keys RigidBody<Dim>::parameters() {
  return velocity_keys();
}

template <int Dim>
RigidBody<Dim>::RigidBody(RigidPoints<Dim> given)
    : CommonMotion<Dim>(std::move(given.name), given.direction, std::move(given.velocity)),
      points_(std::move(given.points)) {}

template <int Dim>
RigidBody<Dim>::RigidBody(const std::string& name, const NodeBox<Dim>& place, const Values& values)
    : CommonMotion<Dim>(name, {.axis = place.axis}, velocity_course(values)), cells_(place) {}

template <int Dim>
void RigidBody<Dim>::bind(const Grid<Dim>& grid, const ShapeFunction<Dim>& scheme) {
  if (!this->velocity_) throw InputError("rigid body '" + this->name() + "' has no velocity");
  if (points_.size() == 0) fill(points_, grid, cells_, this->name());
  initialise(scheme, grid, points_); // they have domains from the start
  stencils_.resize(points_.size(), scheme.max_nodes());
  this->nodes_.clear();
  this->nodes_.reserve(static_cast<std::size_t>(grid.node_count()));
}

template <int Dim>
void RigidBody<Dim>::follow(const Grid<Dim>& grid, const ShapeFunction<Dim>& scheme) {
  std::vector<Index>& nodes = this->nodes_;
  nodes.clear();
  initialise(scheme, grid, points_);
  scheme.evaluate(grid, points_, {0, points_.size()}, stencils_);
  for (Index p = 0; p < points_.size(); ++p) {
    const StencilGroup<Dim>& group = stencils_.group_of(p);
    if (group.lost[p % pack_size]) throw RunError("rigid body '" + this->name() + "' leaves the grid");
    for (int entry = 0; entry < group.count; ++entry)
      if (group.value_of(entry, p % pack_size) > 0.0) nodes.push_back(group.node_of(entry, p % pack_size));
    if (nodes.size() + static_cast<std::size_t>(group.count) > nodes.capacity()) drop_repeated(nodes);
  }
  drop_repeated(nodes);
}

template <int Dim>
void RigidBody<Dim>::move(double time, double dt) {
  const Vec<Dim> direction = this->direction_.vector();
  const double speed = this->velocity_(time), distance = dt * speed;
  for (int a = 0; a < Dim; ++a)
    if (direction[a] != 0.0)
      for (Index p = 0; p < points_.size(); ++p) {
        points_.velocity[a][p] = speed * direction[a];
        points_.position[a][p] += distance * direction[a];
      }
}

template class RigidBody<2>;
template class RigidBody<3>;

} // namespace riedel
