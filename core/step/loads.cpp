#include "core/step/loads.hpp"

#include "core/state/cell_place.hpp"
#include "core/step/kernels/scatter.hpp"

#include <Eigen/LU>

namespace riedel {

namespace {

/// The outer face of a point: a segment, or a parallelogram.
template <int Dim>
struct Face {
  Vec<Dim> middle;                     ///< [m]
  std::array<Vec<Dim>, Dim - 1> edges; ///< [m]
  Vec<Dim> area;                       ///< outward [m² or m]
};

template <int Dim>
Face<Dim> outer_face(const Points<Dim>& points, Index p, const Vec<Dim>& initial_area) {
  Index normal = 0;
  initial_area.cwiseAbs().maxCoeff(&normal);
  const Mat<Dim> F = points.deformation_gradient_of(p);
  const double outward = std::copysign(points.half_size[normal][p], initial_area[normal]);
  Face<Dim> face{.middle = points.position_of(p) + outward * F.col(normal),
                 .edges = {},
                 .area = F.determinant() * F.inverse().transpose() * initial_area}; // Nanson
  for (int a = 0, e = 0; a < Dim; ++a)
    if (a != normal) face.edges[e++] = 2.0 * points.half_size[a][p] * F.col(a);
  return face;
}

/// Calls use(x, share) for positions that integrate hats along an edge exactly: two Gauss points between each two grid
/// lines that it crosses.
template <int Dim, class Use>
void integrate_along(const Grid<Dim>& grid, const Vec<Dim>& middle, const Vec<Dim>& edge, const Use& use) {
  constexpr double on_line = 1e-9; // in cells: shorter pieces are ignored
  double from = -0.5;
  while (from < 0.5) {
    double to = 0.5;
    for (int a = 0; a < Dim; ++a) {
      const double slope = edge[a] / grid.cell[a], at = (middle[a] - grid.origin[a]) / grid.cell[a] + from * slope;
      if (slope == 0.0) continue;
      const double line = slope > 0.0 ? std::floor(at + on_line) + 1.0 : std::ceil(at - on_line) - 1.0;
      to = std::min(to, from + (line - at) / slope);
    }
    const double half = 0.5 * (to - from);
    for (const double sign : {-1.0, 1.0})
      use(Vec<Dim>(middle + (from + half * (1.0 + sign / std::numbers::sqrt3)) * edge), half);
    from = to;
  }
}

template <int Dim, class Use>
void integrate_over(const Grid<Dim>& grid, const Face<Dim>& face, const Use& use) {
  integrate_along<Dim>(grid, face.middle, face.edges[0], [&](const Vec<Dim>& x, double share) {
    if constexpr (Dim == 2)
      use(x, share);
    else
      integrate_along<Dim>(grid, x, face.edges[1], [&](const Vec<Dim>& y, double part) { use(y, share * part); });
  });
}

/// Calls use(x, share) for the corners of a face.
template <int Dim, class Use>
void for_each_corner(const Face<Dim>& face, const Use& use) {
  for (int c = 0; c < power(2, Dim - 1); ++c) {
    Vec<Dim> x = face.middle;
    for (int e = 0; e < Dim - 1; ++e) x += ((c >> e & 1) ? 0.5 : -0.5) * face.edges[e];
    use(x, 1.0 / power(2, Dim - 1));
  }
}

/// Calls use(points, p, place, force) for the parts of every loaded face.
template <int Dim, class Use>
void for_each_force(const State<Dim>& state, const Model<Dim>& model, const Use& use) {
  for (const SurfaceTraction<Dim>& load : model.surface_tractions) {
    const Points<Dim>& points = state.bodies[load.body].points;
    for (std::size_t id = 0; id < load.initial_area.size(); ++id) {
      if (load.initial_area[id].isZero()) continue;
      const Index p = points.place[id];
      const Face<Dim> face = outer_face(points, p, load.initial_area[id]);
      const double size = face.area.norm();
      const Vec<Dim> normal = face.area / size;
      const auto part = [&](const Vec<Dim>& x, double share) {
        use(points, p, x, Vec<Dim>(share * size * load.value(x, normal, state.time)));
      };
      if (model.scheme->traction_at_corners())
        for_each_corner(face, part);
      else
        integrate_over(state.grid, face, part);
    }
  }
}

template <int Dim>
void add_force(State<Dim>& state, const Vec<Dim>& x, const Vec<Dim>& force) {
  const CellPlace<Dim> place(state.grid, x);
  if (!place.inside())
    throw RunError("a loaded face left the grid at step " + std::to_string(state.step) + ", time " +
                   exact_text(state.time) + " s");
  for (int n = 0; n < power(2, Dim); ++n) state.nodes.sums[place.node(n)].force += place.hat(n) * force;
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
void add_surface_tractions(State<Dim>& state, const Model<Dim>& model) {
  for_each_force(state, model, [&](const Points<Dim>&, Index, const Vec<Dim>& x, const Vec<Dim>& force) {
    add_force(state, x, force);
  });
}

template <int Dim>
double surface_work(const State<Dim>& state, const Model<Dim>& model, double dt) {
  double work = 0.0;
  for_each_force(state, model, [&](const Points<Dim>& points, Index p, const Vec<Dim>&, const Vec<Dim>& force) {
    work += dt * force.dot(points.velocity_of(p));
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

template <int Dim>
void add_loads(State<Dim>& state, const Model<Dim>& model) {
  add_surface_tractions(state, model);
  add_body_forces(state, model);
}

template void add_loads<2>(State<2>&, const Model<2>&);
template void add_loads<3>(State<3>&, const Model<3>&);
template void add_surface_tractions<2>(State<2>&, const Model<2>&);
template void add_surface_tractions<3>(State<3>&, const Model<3>&);
template void add_body_forces<2>(State<2>&, const Model<2>&);
template void add_body_forces<3>(State<3>&, const Model<3>&);
template double surface_work<2>(const State<2>&, const Model<2>&, double);
template double surface_work<3>(const State<3>&, const Model<3>&, double);
template double body_work<2>(const State<2>&, const Model<2>&, double);
template double body_work<3>(const State<3>&, const Model<3>&, double);

} // namespace riedel
