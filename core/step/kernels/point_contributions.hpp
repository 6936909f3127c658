/// Contributions of eight points to the grid.
#pragma once

#include "core/base/tensor.hpp"
#include "core/step/kernels/point_motion.hpp"
#include "core/step/kernels/scatter.hpp"

namespace riedel {

/// m_p v_p and m_p of eight points.
template <int Dim>
void mass_and_momentum(const Points<Dim>& points, Index p, PointContributions<Dim>& contributions) {
  const Pack m = Pack::load(points.mass[0] + p);
  std::array<Pack, 4> columns;
  columns.fill(Pack(0.0));
  columns[NodeSums<Dim>::mass_at] = m;
  for (int a = 0; a < Dim; ++a) columns[a] = m * Pack::load(points.velocity[a] + p);
  contributions.mass.put(columns);
}

/// −V_p (σ_p + p I): the stress in excess of the confining pressure p, whose virtual stress −p I acts outside the
/// bodies and needs no nodes there (docs/theory/biaxial.md).
template <int Dim>
void internal_forces(const Points<Dim>& points, Index p, double pressure, PointContributions<Dim>& contributions) {
  const Pack V = -Pack::load(points.volume[0] + p);
  std::array<std::array<Pack, Dim>, Dim> force;
  for (int i = 0; i < Dim; ++i)
    for (int j = 0; j <= i; ++j) {
      const Pack stress = Pack::load(points.stress[static_cast<int>(mandel(i, j))] + p);
      force[i][j] = force[j][i] = i == j ? V * (stress + Pack(pressure)) : V * stress * Pack(std::numbers::sqrt2 / 2);
    }
  contributions.force.put(force);
}

/// m_p v of eight points, without m_p, for nodes whose masses are already known.
template <int Dim>
std::array<Pack, 4> momenta(const Points<Dim>& points, Index p, const std::array<Pack, Dim>& velocity) {
  const Pack m = Pack::load(points.mass[0] + p);
  std::array<Pack, 4> columns;
  columns.fill(Pack(0.0));
  for (int a = 0; a < Dim; ++a) columns[a] = m * velocity[a];
  return columns;
}

template <int Dim>
void clear_momentum(Nodes<Dim>& nodes) {
  parallel_for(nodes.size(), [&](Index i) { nodes.sums[i].momentum.setZero(); });
}

/// Adds the contributions of eight points at a time, from `fill(points, p, contributions)`.
/// @return whether all points kept to their slab
template <Use use, int Dim, class Fill>
bool add_contributions(State<Dim>& state, const Model<Dim>& model, Body<Dim>& body, const Fill& fill) {
  return add_in_slab_order<PointContributions<Dim>>(
      state, model, body, [&](const SlabGroup<Dim>& group, PointContributions<Dim>& contributions) {
        fill(body.points, group.first, contributions);
        scatter<use>(group, contributions, state.nodes);
      });
}

/// Stores the lanes of a group that belong to its slab; the others belong to another thread.
inline void store_lanes(double* column, const Pack& values, Range lanes) {
  if (lanes.size() == pack_size) return values.store(column);
  std::array<double, pack_size> lane;
  values.store(lane.data());
  std::copy(lane.begin() + lanes.begin, lane.begin() + lanes.end, column + lanes.begin);
}

/// Stores v_p, and the postponed displacement of a slab's points.
template <int Dim>
void keep(const NewMotion<Dim>& motion, Body<Dim>& body, const SlabGroup<Dim>& group) {
  for (int a = 0; a < Dim; ++a) {
    store_lanes(body.points.velocity[a] + group.first, motion.velocity[a], group.lanes);
    store_lanes(body.displacement_increment[a] + group.first, motion.displacement_increment[a], group.lanes);
  }
}

} // namespace riedel
