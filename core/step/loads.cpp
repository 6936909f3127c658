#include "core/step/loads.hpp"

#include <Eigen/LU>

namespace riedel {

namespace {
/// Calls use(point, force) for each point that carries pressure.
template <int Dim, class Use>
void for_each_force(const State<Dim>& state, const Model<Dim>& model, const Use& use) {
  for (const SurfacePressure<Dim>& load : model.surface_pressures) {
    const Body<Dim>& body = state.bodies[load.body];
    for (std::size_t id = 0; id < load.initial_area.size(); ++id) {
      if (load.initial_area[id].isZero()) continue;
      const Index p = body.points.place[id];
      const Mat<Dim> F = body.points.deformation_gradient_of(p);
      const Vec<Dim> area = F.determinant() * F.inverse().transpose() * load.initial_area[id]; // Nanson
      use(body, p, Vec<Dim>(-load.pressure * area));
    }
  }
}
} // namespace

template <int Dim>
void add_surface_pressures(State<Dim>& state, const Model<Dim>& model) {
  for_each_force(state, model, [&](const Body<Dim>& body, Index p, const Vec<Dim>& force) {
    const StencilGroup<Dim>& group = body.stencils.group_of(p);
    for (int at = p % pack_size; at < group.count * pack_size; at += pack_size)
      state.nodes.sums[group.node[at]].force += group.value[at] * force;
  });
}

template <int Dim>
double surface_work(const State<Dim>& state, const Model<Dim>& model, double dt) {
  double work = 0.0;
  for_each_force(state, model, [&](const Body<Dim>& body, Index p, const Vec<Dim>& force) {
    work += dt * force.dot(body.points.velocity_of(p));
  });
  return work;
}

template void add_surface_pressures<2>(State<2>&, const Model<2>&);
template void add_surface_pressures<3>(State<3>&, const Model<3>&);
template double surface_work<2>(const State<2>&, const Model<2>&, double);
template double surface_work<3>(const State<3>&, const Model<3>&, double);

} // namespace riedel
