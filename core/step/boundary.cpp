#include "core/step/boundary.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace riedel {

namespace {
void drop_repeated(std::vector<Index>& nodes) {
  std::sort(nodes.begin(), nodes.end());
  nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
}

template <int Dim>
bool within_box(const Counts<Dim>& index, const Counts<Dim>& first, const Counts<Dim>& last) {
  bool inside = true;
  for (int a = 0; a < Dim; ++a) inside = inside && index[a] >= first[a] && index[a] <= last[a];
  return inside;
}

template <int Dim>
std::vector<double> shares_of(const Grid<Dim>& grid, const LinearMotion& linear, const std::vector<Index>& nodes) {
  std::vector<double> shares;
  for (const Index i : nodes)
    shares.push_back(static_cast<double>(grid.index(i)[linear.axis] - linear.fixed_row) /
                     static_cast<double>(linear.moving_row - linear.fixed_row));
  return shares;
}

/// The one velocity that leaves the nodes' momentum along their motion as it is.
template <int Dim>
double common_velocity(const Nodes<Dim>& nodes, const HeldNodes<Dim>& held) {
  double momentum = 0.0, mass = 0.0;
  for (std::size_t k = 0; k < held.nodes.size(); ++k) {
    const Index i = held.nodes[k];
    const double m = nodes.sums[i].mass * held.share(k);
    momentum += m * held.along(nodes.motion[i].velocity);
    mass += m * held.share(k);
  }
  return mass > 0.0 ? momentum / mass : 0.0;
}

template <int Dim>
double velocity_of(const Nodes<Dim>& nodes, const HeldNodes<Dim>& held, double time) {
  return held.velocity ? held.velocity(time) : common_velocity(nodes, held);
}
} // namespace

std::function<double(double)> ramped(double speed, double ramp_time) {
  return [=](double t) {
    if (t >= ramp_time) return speed;
    return speed * 0.5 * (1.0 - std::cos(std::numbers::pi * std::max(t, 0.0) / ramp_time));
  };
}

template <int Dim>
std::vector<Index> nodes_of(const Grid<Dim>& grid, const NodeCondition<Dim>& condition) {
  std::vector<Index> nodes;
  for (Index i = 0; i < grid.node_count(); ++i) {
    const Counts<Dim> index = grid.index(i);
    if (!within_box<Dim>(index, condition.first, condition.last)) continue;
    if (condition.but_for && within_box<Dim>(index, condition.but_for->front(), condition.but_for->back())) continue;
    nodes.push_back(i);
  }
  return nodes;
}

template <int Dim>
std::array<Walls, Dim> walls_of(const Grid<Dim>& grid, const std::vector<NodeCondition<Dim>>& conditions) {
  std::array<Walls, Dim> walls{};
  for (const NodeCondition<Dim>& c : conditions) {
    bool across = true; // covers the grid from side to side
    for (int a = 0; a < Dim; ++a)
      across = across && (a == c.axis || (c.first[a] <= 0 && c.last[a] >= grid.nodes[a] - 1));
    if (!across) continue;
    Walls& wall = walls[c.axis];
    if (c.linear && c.linear->axis == c.axis) {
      wall.first = std::max(wall.first, c.linear->fixed_row);
      wall.last = std::min(wall.last, c.linear->moving_row);
      continue;
    }
    const bool from_below = c.first[c.axis] <= 0, from_above = c.last[c.axis] >= grid.nodes[c.axis] - 1;
    if (from_below && !from_above) wall.first = std::max(wall.first, c.last[c.axis]);
    if (from_above && !from_below) wall.last = std::min(wall.last, c.first[c.axis]);
  }
  return walls;
}

template <int Dim>
void bind_conditions(State<Dim>& state, const std::vector<NodeCondition<Dim>>& conditions) {
  state.grid.walls = walls_of(state.grid, conditions);
  state.held.clear();
  for (const NodeCondition<Dim>& c : conditions) {
    HeldNodes<Dim>& held = state.held.emplace_back();
    held.name = c.name;
    held.axis = c.axis;
    held.nodes = nodes_of(state.grid, c);
    held.velocity = c.velocity;
    if (c.linear) held.shares = shares_of(state.grid, *c.linear, held.nodes);
  }
  for (const RigidBody<Dim>& body : state.rigid_bodies) {
    HeldNodes<Dim>& held = state.held.emplace_back();
    held.name = body.name;
    held.axis = body.axis;
    held.direction = body.direction;
    held.velocity = body.velocity;
    held.nodes.reserve(static_cast<std::size_t>(state.grid.node_count()));
  }
}

template <int Dim>
void find_rigid_nodes(State<Dim>& state, const ShapeFunction<Dim>& scheme) {
  for (std::size_t b = 0; b < state.rigid_bodies.size(); ++b) {
    RigidBody<Dim>& body = state.rigid_bodies[b];
    std::vector<Index>& nodes = state.held[state.held.size() - state.rigid_bodies.size() + b].nodes;
    nodes.clear();
    start(scheme, state.grid, body.points);
    scheme.evaluate(state.grid, body.points, {0, body.points.size()}, body.stencils);
    for (Index p = 0; p < body.points.size(); ++p) {
      const StencilGroup<Dim>& group = body.stencils.group_of(p);
      if (group.lost[p % pack_size]) throw RunError("rigid body '" + body.name + "' leaves the grid");
      for (int entry = 0; entry < group.count; ++entry)
        if (group.value_of(entry, p % pack_size) > 0.0) nodes.push_back(group.node_of(entry, p % pack_size));
      if (nodes.size() + static_cast<std::size_t>(group.count) > nodes.capacity()) drop_repeated(nodes);
    }
    drop_repeated(nodes);
  }
}

template <int Dim>
void move_rigid_points(State<Dim>& state, double time, double dt) {
  for (RigidBody<Dim>& body : state.rigid_bodies) {
    const Vec<Dim> direction = body.axis == oblique ? body.direction : Vec<Dim>(Vec<Dim>::Unit(body.axis));
    const double way = dt * body.velocity(time);
    for (int a = 0; a < Dim; ++a)
      if (direction[a] != 0.0)
        for (Index p = 0; p < body.points.size(); ++p) body.points.position[a][p] += way * direction[a];
  }
}

template <int Dim>
void hold_nodes(State<Dim>& state, double time, double dt) {
  for (HeldNodes<Dim>& held : state.held) {
    const double speed_before = held.speed;
    held.speed = velocity_of(state.nodes, held, time);
    double impulse = 0.0;
    for (std::size_t k = 0; k < held.nodes.size(); ++k) {
      const Index i = held.nodes[k];
      NodeMotion<Dim>& motion = state.nodes.motion[i];
      const double v = held.share(k) * held.speed, change = v - held.along(motion.velocity);
      const double mass = state.nodes.sums[i].mass, free = held.along(motion.velocity);
      const double force = mass * held.along(motion.acceleration), change_of_force = mass * change / dt;
      impulse += held.share(k) * mass * change;
      state.node_power.start += change_of_force * held.share(k) * speed_before;
      state.node_power.end += (force + change_of_force) * v - force * free;
      held.set(motion.velocity, v);
      held.add(motion.acceleration, change / dt);
    }
    held.reaction = impulse / dt;
    state.boundary_work += impulse * held.speed;
  }
}

template <int Dim>
void hold_velocities(State<Dim>& state, double time) {
  for (const HeldNodes<Dim>& held : state.held) {
    const double v = velocity_of(state.nodes, held, time);
    for (std::size_t k = 0; k < held.nodes.size(); ++k) {
      const Index i = held.nodes[k];
      NodeMotion<Dim>& motion = state.nodes.motion[i];
      const double change = held.share(k) * v - held.along(motion.velocity);
      state.node_power.end += state.nodes.sums[i].mass * held.along(motion.acceleration) * change;
      held.set(motion.velocity, held.share(k) * v);
    }
  }
}

template std::vector<Index> nodes_of<2>(const Grid<2>&, const NodeCondition<2>&);
template std::vector<Index> nodes_of<3>(const Grid<3>&, const NodeCondition<3>&);
template std::array<Walls, 2> walls_of<2>(const Grid<2>&, const std::vector<NodeCondition<2>>&);
template std::array<Walls, 3> walls_of<3>(const Grid<3>&, const std::vector<NodeCondition<3>>&);
template void bind_conditions<2>(State<2>&, const std::vector<NodeCondition<2>>&);
template void bind_conditions<3>(State<3>&, const std::vector<NodeCondition<3>>&);
template void find_rigid_nodes<2>(State<2>&, const ShapeFunction<2>&);
template void find_rigid_nodes<3>(State<3>&, const ShapeFunction<3>&);
template void move_rigid_points<2>(State<2>&, double, double);
template void move_rigid_points<3>(State<3>&, double, double);
template void hold_nodes<2>(State<2>&, double, double);
template void hold_nodes<3>(State<3>&, double, double);
template void hold_velocities<2>(State<2>&, double);
template void hold_velocities<3>(State<3>&, double);

} // namespace riedel
