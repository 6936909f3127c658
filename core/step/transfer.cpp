#include "core/step/transfer.hpp"

#include "core/base/parallel.hpp"
#include "core/base/tensor.hpp"
#include "core/step/loads.hpp"

namespace riedel {

namespace {

/// Node by node of one point: use(node, N, entry) for each entry of its stencil.
template <int Dim, class Use>
void for_each_entry(const Stencils<Dim>& stencils, Index p, const Use& use) {
  const StencilGroup<Dim>& group = stencils.group_of(p);
  const int lane = p % pack_size;
  for (int entry = 0; entry < group.count; ++entry) use(group, entry, entry * pack_size + lane);
}

template <int Dim>
Vec<Dim> slope_of(const StencilGroup<Dim>& group, int entry, Index p) {
  Vec<Dim> slope;
  for (int a = 0; a < Dim; ++a) slope[a] = group.slope[(entry * Dim + a) * pack_size + p % pack_size];
  return slope;
}

/// Calls add(point) for all points of all bodies, in an order that no number of threads changes: even slabs, then odd.
template <int Dim, class Add>
void in_slab_order(const Body<Dim>& body, const Add& add) {
  for (Index parity = 0; parity < 2; ++parity)
    parallel_for((body.slabs.count() - parity + 1) / 2, [&](Index s) {
      const Range points = body.slabs.range(2 * s + parity);
      for (Index p = points.begin; p < points.end; ++p) add(p);
    });
}

/// V_p (σ_p + p I), the stress in excess of the confining pressure.
template <int Dim>
Mat<Dim> excess_stress(const Points<Dim>& points, Index p, double pressure) {
  constexpr double r = std::numbers::sqrt2 / 2;
  Mat<Dim> sigma;
  if constexpr (Dim == 2) {
    sigma << points.stress[0][p] + pressure, r * points.stress[3][p], r * points.stress[3][p],
        points.stress[1][p] + pressure;
  } else {
    Sym<double> s;
    for (int c = 0; c < 6; ++c) s.m[c] = points.stress[c][p];
    sigma = to_matrix(s) + pressure * Mat<Dim>::Identity();
  }
  return points.volume[0][p] * sigma;
}

/// Nodes with less than a round-off share of a point carry no motion.
template <int Dim>
double least_mass(const State<Dim>& state) {
  return 1e-12 * state.bodies.front().points.mass[0][0];
}

} // namespace

template <int Dim>
void points_to_grid(State<Dim>& state, const Model<Dim>& model) {
  state.nodes.clear_sums();
  for (Body<Dim>& body : state.bodies) {
    const Points<Dim>& points = body.points;
    in_slab_order(body, [&](Index p) {
      const double m = points.mass[0][p];
      const Vec<Dim> mv = m * points.velocity_of(p), mb = m * model.gravity;
      const Mat<Dim> stress = excess_stress(points, p, model.confining_pressure);
      for_each_entry(body.stencils, p, [&](const StencilGroup<Dim>& group, int entry, int at) {
        const double N = group.value[at];
        NodeSums<Dim>& node = state.nodes.sums[group.node[at]];
        node.mass += N * m;
        node.momentum += N * mv;
        node.force += N * mb - stress * slope_of(group, entry, p);
      });
    });
  }
  add_surface_pressures(state, model);
}

template <int Dim>
void map_mass_and_momentum(State<Dim>& state) {
  state.nodes.clear_sums();
  for (Body<Dim>& body : state.bodies) {
    const Points<Dim>& points = body.points;
    in_slab_order(body, [&](Index p) {
      const double m = points.mass[0][p];
      const Vec<Dim> mv = m * points.velocity_of(p);
      for_each_entry(body.stencils, p, [&](const StencilGroup<Dim>& group, int, int at) {
        const double N = group.value[at];
        NodeSums<Dim>& node = state.nodes.sums[group.node[at]];
        node.mass += N * m;
        node.momentum += N * mv;
      });
    });
  }
  advance_momentum(state, 0.0);
}

template <int Dim>
void map_forces(State<Dim>& state, const Model<Dim>& model) {
  for (Body<Dim>& body : state.bodies) {
    const Points<Dim>& points = body.points;
    in_slab_order(body, [&](Index p) {
      const Vec<Dim> mb = points.mass[0][p] * model.gravity;
      const Mat<Dim> stress = excess_stress(points, p, model.confining_pressure);
      for_each_entry(body.stencils, p, [&](const StencilGroup<Dim>& group, int entry, int at) {
        state.nodes.sums[group.node[at]].force += group.value[at] * mb - stress * slope_of(group, entry, p);
      });
    });
  }
  add_surface_pressures(state, model);
}

template <int Dim>
void remap_velocity(State<Dim>& state) {
  parallel_for(state.nodes.size(), [&](Index i) { state.nodes.sums[i].momentum.setZero(); });
  for (Body<Dim>& body : state.bodies) {
    const Points<Dim>& points = body.points;
    in_slab_order(body, [&](Index p) {
      const Vec<Dim> mv = points.mass[0][p] * points.velocity_of(p);
      for_each_entry(body.stencils, p, [&](const StencilGroup<Dim>& group, int, int at) {
        state.nodes.sums[group.node[at]].momentum += group.value[at] * mv;
      });
    });
  }
  const double least = least_mass(state);
  parallel_for(state.nodes.size(), [&](Index i) {
    const NodeSums<Dim>& sums = state.nodes.sums[i];
    if (sums.mass > least) state.nodes.motion[i].velocity = sums.momentum / sums.mass;
  });
}

template <int Dim>
void advance_momentum(State<Dim>& state, double dt) {
  const double least = least_mass(state);
  parallel_for(state.nodes.size(), [&](Index i) {
    const NodeSums<Dim>& sums = state.nodes.sums[i];
    NodeMotion<Dim>& motion = state.nodes.motion[i];
    if (sums.mass > least) {
      motion.acceleration = sums.force / sums.mass;
      motion.velocity = sums.momentum / sums.mass + dt * motion.acceleration;
    } else {
      motion = {};
    }
  });
}

template <int Dim>
void grid_to_points(State<Dim>& state, const Model<Dim>& model, double dt) {
  for (Body<Dim>& body : state.bodies) {
    Points<Dim>& points = body.points;
    for_each_block(points.size(), [&](Range block) {
      for (Index p = block.begin; p < block.end; ++p) {
        Vec<Dim> v = Vec<Dim>::Zero(), a = Vec<Dim>::Zero();
        for_each_entry(body.stencils, p, [&](const StencilGroup<Dim>& group, int, int at) {
          const NodeMotion<Dim>& motion = state.nodes.motion[group.node[at]];
          v += group.value[at] * motion.velocity;
          a += group.value[at] * motion.acceleration;
        });
        for (int i = 0; i < Dim; ++i) {
          double& v_p = points.velocity[i][p];
          v_p = model.flip * (v_p + dt * a[i]) + (1.0 - model.flip) * v[i];
          points.position[i][p] += dt * v[i];
        }
      }
    });
  }
}

template void points_to_grid<2>(State<2>&, const Model<2>&);
template void points_to_grid<3>(State<3>&, const Model<3>&);
template void map_mass_and_momentum<2>(State<2>&);
template void map_mass_and_momentum<3>(State<3>&);
template void map_forces<2>(State<2>&, const Model<2>&);
template void map_forces<3>(State<3>&, const Model<3>&);
template void advance_momentum<2>(State<2>&, double);
template void advance_momentum<3>(State<3>&, double);
template void grid_to_points<2>(State<2>&, const Model<2>&, double);
template void grid_to_points<3>(State<3>&, const Model<3>&, double);
template void remap_velocity<2>(State<2>&);
template void remap_velocity<3>(State<3>&);

} // namespace riedel
