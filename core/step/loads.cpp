#include "core/step/loads.hpp"

#include "core/state/cell_place.hpp"
#include "core/step/scatter.hpp"

#include <Eigen/LU>

namespace riedel {

namespace {

/// The pressure on one point's outer face.
template <int Dim>
struct FaceForce {
  Vec<Dim> position; ///< middle of the face [m]
  Vec<Dim> force;    ///< [N or N/m]
};

/// Calls use(point, face) for each point that carries pressure.
template <int Dim, class Use>
void for_each_face(const State<Dim>& state, const Model<Dim>& model, const Use& use) {
  for (const SurfacePressure<Dim>& load : model.surface_pressures) {
    const Points<Dim>& points = state.bodies[load.body].points;
    for (std::size_t id = 0; id < load.initial_area.size(); ++id) {
      const Vec<Dim>& A = load.initial_area[id];
      if (A.isZero()) continue;
      const Index p = points.place[id];
      const Mat<Dim> F = points.deformation_gradient_of(p);
      Vec<Dim> half = A.normalized();
      for (int a = 0; a < Dim; ++a) half[a] *= points.half_size[a][p];
      const Vec<Dim> area = F.determinant() * F.inverse().transpose() * A; // Nanson
      use(points, p, FaceForce<Dim>{points.position_of(p) + F * half, -load.pressure * area});
    }
  }
}

/// Adds a force to the nodes of the cell that holds its place, with multilinear hats whatever the scheme: the place is
/// on the edge of the material, where hats balance a uniform stress.
template <int Dim>
void add_force(State<Dim>& state, const FaceForce<Dim>& face) {
  const CellPlace<Dim> place(state.grid, face.position);
  if (!place.inside())
    throw RunError("a loaded face left the grid at step " + std::to_string(state.step) + ", time " +
                   exact_text(state.time) + " s");
  for (int n = 0; n < power(2, Dim); ++n) state.nodes.sums[place.node(n)].force += place.hat(n) * face.force;
}

/// Adds N_ip times the force on each lane to the nodes.
template <int Dim>
void add_values(const SlabGroup<Dim>& group, const std::array<Vec<Dim>, pack_size>& forces, Nodes<Dim>& nodes) {
  const StencilEntries<Dim> stencil = group.stencil;
  with_shape(stencil.shape, [&](auto shape) {
    PatchLane<shape, Dim> patch(stencil, group.lanes.begin);
    for (int n = 0; n < stencil.count; n += patch.entries, patch.to_next_patch()) {
      PatchLane<shape, Dim> lane = patch;
      for (Index k = group.lanes.begin; k < group.lanes.end; ++k, lane.to_next_lane())
        lane.for_each_node(nodes.sums.data(),
                           [&](int e, NodeSums<Dim>& node) { node.force += lane.value_of(e) * forces[k]; });
    }
  });
}

} // namespace

template <int Dim>
void add_surface_pressures(State<Dim>& state, const Model<Dim>& model) {
  for_each_face(state, model, [&](const Points<Dim>&, Index, const FaceForce<Dim>& face) { add_force(state, face); });
}

template <int Dim>
double surface_work(const State<Dim>& state, const Model<Dim>& model, double dt) {
  double work = 0.0;
  for_each_face(state, model, [&](const Points<Dim>& points, Index p, const FaceForce<Dim>& face) {
    work += dt * face.force.dot(points.velocity_of(p));
  });
  return work;
}

template <int Dim>
void add_body_forces(State<Dim>& state, const Model<Dim>& model) {
  for (const BodyForce<Dim>& load : model.body_forces) {
    Body<Dim>& body = state.bodies[load.body];
    using Forces = std::array<Vec<Dim>, pack_size>;
    add_in_slab_order<Forces>(state, model, body, [&](const SlabGroup<Dim>& group, Forces& forces) {
      for (Index k = group.lanes.begin; k < group.lanes.end; ++k) {
        const Index p = group.first + k;
        forces[k] = body.points.mass[0][p] * load.per_mass(body.points, p, state.time);
      }
      add_values(group, forces, state.nodes);
    });
  }
}

template <int Dim>
double body_work(const State<Dim>& state, const Model<Dim>& model, double dt) {
  double work = 0.0;
  for (const BodyForce<Dim>& load : model.body_forces) {
    const Points<Dim>& points = state.bodies[load.body].points;
    for (Index p = 0; p < points.size(); ++p)
      work += dt * points.mass[0][p] * load.per_mass(points, p, state.time).dot(points.velocity_of(p));
  }
  return work;
}

template void add_surface_pressures<2>(State<2>&, const Model<2>&);
template void add_surface_pressures<3>(State<3>&, const Model<3>&);
template void add_body_forces<2>(State<2>&, const Model<2>&);
template void add_body_forces<3>(State<3>&, const Model<3>&);
template double surface_work<2>(const State<2>&, const Model<2>&, double);
template double surface_work<3>(const State<3>&, const Model<3>&, double);
template double body_work<2>(const State<2>&, const Model<2>&, double);
template double body_work<3>(const State<3>&, const Model<3>&, double);

} // namespace riedel
