#include "core/step/transfer.hpp"

#include "core/step/loads.hpp"
#include "core/step/locate.hpp"
#include "core/step/scatter.hpp"
#include "core/step/slab_order.hpp"

namespace riedel {

namespace {

constexpr int mandel(int i, int j) { return i == j ? i : i + j + 2; } ///< place of σ_ij in the order 11 22 33 12 13 23

/// m_p v_p and m_p of eight points.
template <int Dim>
void put_mass_and_momentum(const Points<Dim>& points, Index p, Shares<Dim>& shares) {
  const Pack m = Pack::load(points.mass[0] + p);
  std::array<Pack, 4> columns;
  columns.fill(Pack(0.0));
  columns[NodeSums<Dim>::mass_at] = m;
  for (int a = 0; a < Dim; ++a) columns[a] = m * Pack::load(points.velocity[a] + p);
  shares.mass.put(columns);
}

/// −V_p (σ_p + p I), the stress in excess of the confining pressure.
template <int Dim>
void put_forces(const Points<Dim>& points, Index p, double pressure, Shares<Dim>& shares) {
  const Pack V = -Pack::load(points.volume[0] + p);
  std::array<std::array<Pack, Dim>, Dim> force;
  for (int i = 0; i < Dim; ++i)
    for (int j = 0; j <= i; ++j) {
      const Pack stress = Pack::load(points.stress[mandel(i, j)] + p);
      force[i][j] = force[j][i] = i == j ? V * (stress + Pack(pressure)) : V * stress * Pack(std::numbers::sqrt2 / 2);
    }
  shares.force.put(force);
}

/// Adds what `fill(points, p, shares)` says that eight points give. @return whether no point strayed from its slab
template <Use use, int Dim, class Fill>
bool add_shares(State<Dim>& state, const Model<Dim>& model, Body<Dim>& body, const Fill& fill) {
  return add_in_slab_order<Shares<Dim>>(state, model, body, [&](const SlabGroup<Dim>& group, Shares<Dim>& shares) {
    fill(body.points, group.first, shares);
    scatter<use>(group, shares, state.nodes);
  });
}

/// The first sums of a step: sorts points that stray and starts again.
template <Use use, int Dim, class Fill>
void sum_from_zero(State<Dim>& state, const Model<Dim>& model, const Fill& fill) {
  const PhaseClock::Lap lap(state.clock, Phase::p2g);
  for (int attempt = 0;; ++attempt) {
    state.nodes.clear_sums();
    bool complete = true;
    for (Body<Dim>& body : state.bodies) complete = add_shares<use>(state, model, body, fill) && complete;
    if (complete) return;
    sort_strays(state, model, attempt > 0);
  }
}

/// Of a node that carries motion.
template <int Dim>
double least_mass(const State<Dim>& state, const Model<Dim>& model) {
  return model.scheme->least_weight() * state.bodies.front().points.mass[0][0];
}

} // namespace

template <int Dim>
void points_to_grid(State<Dim>& state, const Model<Dim>& model) {
  sum_from_zero<Use::both>(state, model, [&](const Points<Dim>& points, Index p, Shares<Dim>& shares) {
    put_mass_and_momentum(points, p, shares);
    put_forces(points, p, model.confining_pressure, shares);
  });
  add_surface_pressures(state, model);
}

template <int Dim>
void map_mass_and_momentum(State<Dim>& state, const Model<Dim>& model) {
  sum_from_zero<Use::values>(state, model, put_mass_and_momentum<Dim>);
  advance_momentum(state, model, 0.0);
}

template <int Dim>
void map_forces(State<Dim>& state, const Model<Dim>& model) {
  const PhaseClock::Lap lap(state.clock, Phase::p2g);
  for (Body<Dim>& body : state.bodies)
    add_shares<Use::slopes>(state, model, body, [&](const Points<Dim>& points, Index p, Shares<Dim>& shares) {
      put_forces(points, p, model.confining_pressure, shares);
    });
  add_surface_pressures(state, model);
}

template <int Dim>
void advance_momentum(State<Dim>& state, const Model<Dim>& model, double dt) {
  const PhaseClock::Lap lap(state.clock, Phase::grid);
  const double least = least_mass(state, model);
  parallel_for(state.nodes.size(), [&](Index i) {
    const NodeSums<Dim>& sums = state.nodes.sums[i];
    NodeMotion<Dim>& motion = state.nodes.motion[i];
    if (sums.mass > least) {
      const double per_mass = 1.0 / sums.mass;
      motion.acceleration = per_mass * sums.force + model.gravity;
      motion.velocity = per_mass * sums.momentum + dt * motion.acceleration;
    } else {
      motion = {};
    }
  });
}

template <int Dim>
void divide_momentum(State<Dim>& state, const Model<Dim>& model) {
  const PhaseClock::Lap lap(state.clock, Phase::grid);
  const double least = least_mass(state, model);
  parallel_for(state.nodes.size(), [&](Index i) {
    const NodeSums<Dim>& sums = state.nodes.sums[i];
    if (sums.mass > least) state.nodes.motion[i].velocity = sums.momentum * (1.0 / sums.mass);
  });
}

template void points_to_grid<2>(State<2>&, const Model<2>&);
template void points_to_grid<3>(State<3>&, const Model<3>&);
template void map_mass_and_momentum<2>(State<2>&, const Model<2>&);
template void map_mass_and_momentum<3>(State<3>&, const Model<3>&);
template void map_forces<2>(State<2>&, const Model<2>&);
template void map_forces<3>(State<3>&, const Model<3>&);
template void advance_momentum<2>(State<2>&, const Model<2>&, double);
template void advance_momentum<3>(State<3>&, const Model<3>&, double);
template void divide_momentum<2>(State<2>&, const Model<2>&);
template void divide_momentum<3>(State<3>&, const Model<3>&);

} // namespace riedel
