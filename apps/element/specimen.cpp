#include "apps/element/specimen.hpp"

#include "core/step/boundaries/prescribed_velocity.hpp"
#include "materials/element/wave_speeds.hpp"

namespace riedel {

namespace {

/// Row numbers and sizes of the specimen in its grid.
template <int Dim>
struct Frame {
  double edge; ///< of the specimen [m]
  Index cells; ///< along each edge
  Index first; ///< row of nodes at the specimen's lower faces
  bool shear, free_interior;
  Grid<Dim> grid;

  Frame(const ElementCase& given, const ShapeFunction<Dim>& scheme)
      : edge(given.specimen.size),
        cells(static_cast<Index>(given.specimen.cells)),
        first(scheme.margin() + 1),
        shear(given.named->shears()),
        free_interior(given.specimen.free_interior) {
    grid.cell.setConstant(edge / cells);
    grid.origin = -static_cast<double>(first) * grid.cell;
    grid.nodes.fill(cells + 2 * first + 1);
    // Sheared points move through the grid.
    if (shear) grid.nodes[0] += static_cast<Index>(std::ceil(given.loading.final_strain * cells));
  }

  [[nodiscard]] Counts<Dim> last_node() const {
    Counts<Dim> last = grid.nodes;
    for (Index& n : last) --n;
    return last;
  }
};

/// The pair of plates normal to an axis, and the nodes beyond them, which move as if the specimen continued there: a
/// domain that reaches over the edge then has the same gradient. The nodes between the plates follow, or are free.
template <int Dim>
VelocityOnNodes<Dim> plates(const Frame<Dim>& frame, int axis, PlateMotion motion, const VelocityCourse& drive) {
  const Index moving = frame.first + frame.cells;
  VelocityOnNodes<Dim> condition{.name = "plates " + std::to_string(axis + 1), .last = frame.last_node(), .axis = axis};
  if (motion == PlateMotion::fixed) condition.velocity = [](double) { return 0.0; };
  if (motion == PlateMotion::driven) condition.velocity = drive;
  condition.linear = LinearMotion{.axis = axis, .fixed_row = frame.first, .moving_row = moving};
  if (frame.free_interior && frame.cells > 1) {
    Counts<Dim> from{}, to = condition.last;
    from[axis] = frame.first + 1;
    to[axis] = moving - 1;
    condition.but_for = {from, to};
  }
  return condition;
}

/// Sheared planes stay plane; they slide and rise in proportion to their height, as in a stack of rings. The inclined
/// sides of the specimen fall between the nodes, so that the condition holds for every node.
template <int Dim>
VelocityOnNodes<Dim> sheared_planes(const Frame<Dim>& frame, int axis, const VelocityCourse& drive) {
  return {.name = "plates " + std::to_string(axis + 1),
          .last = frame.last_node(),
          .axis = axis,
          .velocity = axis == 0 ? drive : nullptr,
          .linear = LinearMotion{.axis = 1, .fixed_row = frame.first, .moving_row = frame.first + frame.cells}};
}

template <int Dim>
void set_boundaries(Model<Dim>& model, const Frame<Dim>& frame, const ElementCase& given) {
  const double sense = frame.shear ? 1.0 : -1.0;
  const auto drive = ramped(sense * given.loading.speed, given.loading.ramp_time);
  for (int axis = 0; axis < Dim; ++axis) {
    const PlateMotion motion = given.named->plates[static_cast<std::size_t>(axis)];
    const bool slides = frame.shear && axis < 2;
    model.conditions.push_back(
        prescribe(slides ? sheared_planes(frame, axis, drive) : plates(frame, axis, motion, drive)));
    if (motion == PlateMotion::fixed || (frame.shear && axis == 0)) continue;
    model.moving_grids.push_back({.axis = axis,
                                  .fixed_row = frame.first,
                                  .moving_row = frame.first + frame.cells,
                                  .platen = model.conditions.back()->name()});
  }
}

template <int Dim>
void fill(Body<Dim>& body, const Frame<Dim>& frame, const ElementCase& given, const Sym<double>& stress) {
  const auto per_edge = static_cast<Index>(frame.cells * given.specimen.points_per_cell);
  const double spacing = frame.edge / per_edge;
  std::vector<double> state = body.material->initial_state();
  const int e = state_column(body.material->states(), "void_ratio");
  if (e >= 0) state[static_cast<std::size_t>(e)] = given.void_ratio;
  const double mass = body.material->density(state) * std::pow(spacing, Dim);
  Points<Dim>& points = body.points;
  points.resize(static_cast<Index>(std::pow(per_edge, Dim)), static_cast<int>(state.size()));
  for (Index p = 0; p < points.size(); ++p) {
    for (int a = 0, rest = p; a < Dim; rest /= per_edge, ++a) {
      points.position[a][p] = (rest % per_edge + 0.5) * spacing;
      points.half_size[a][p] = 0.5 * spacing;
    }
    points.volume[0][p] = points.initial_volume[0][p] = std::pow(spacing, Dim);
    points.mass[0][p] = mass;
    for (int c = 0; c < 6; ++c) points.stress[c][p] = stress.m[static_cast<std::size_t>(c)];
    for (std::size_t s = 0; s < state.size(); ++s) points.state[static_cast<int>(s)][p] = state[s];
  }
}

} // namespace

template <int Dim>
Simulation<Dim> make_element(const ElementCase& given, const Catalogue& catalogue, const Sym<double>& stress) {
  Model<Dim> model;
  model.scheme = catalogue.in<Dim>().schemes.find(given.scheme).make(given.interpolation);
  std::unique_ptr<Material> law = catalogue.materials.find(given.material.model).make(given.material.parameters);
  const double pressure = -(stress.m[0] + stress.m[1] + stress.m[2]) / 3.0;
  set_step(model, given.keys, catalogue, wave_speeds(*law, pressure, given.void_ratio).at_start / given.specimen.size,
           element_step_defaults);
  const Frame<Dim> frame(given, *model.scheme);
  set_boundaries(model, frame, given);
  if (given.named->confined) model.confining_pressure = -stress.m[1];
  State<Dim> state;
  state.grid = frame.grid;
  Body<Dim>& body = state.bodies.emplace_back();
  body.name = "specimen";
  body.material = std::move(law);
  fill(body, frame, given, stress);
  return {std::move(model), std::move(state)};
}

template <int Dim>
void follow_element(MaterialPoint& mean, const Simulation<Dim>& simulation) {
  const Points<Dim>& points = simulation.state().bodies.front().points;
  const double slide = mean.F(0, 1);
  double volume = 0.0, volume_0 = 0.0;
  Mat<Dim> F = Mat<Dim>::Zero();
  mean.stress = Sym<double>::zero();
  std::ranges::fill(mean.state, 0.0);
  for (Index p = 0; p < points.size(); ++p) {
    const double V = points.volume[0][p], V_0 = points.initial_volume[0][p];
    volume += V;
    volume_0 += V_0;
    F += V_0 * points.deformation_gradient_of(p);
    for (int c = 0; c < 6; ++c) mean.stress.m[static_cast<std::size_t>(c)] += V * points.stress[c][p];
    for (int c = 0; c < points.state.components(); ++c)
      mean.state[static_cast<std::size_t>(c)] += V * points.state[c][p];
  }
  mean.stress = mean.stress / volume;
  for (double& s : mean.state) s /= volume;
  mean.F.template topLeftCorner<Dim, Dim>() = F / volume_0;
  for (int a = 0; a < Dim; ++a) mean.strain.m[static_cast<std::size_t>(a)] = std::log(mean.F(a, a));
  mean.strain.m[3] += (mean.F(0, 1) - slide) / mean.F(1, 1) / std::numbers::sqrt2; // √2 D_12 Δt
  mean.time = simulation.state().time;
}

template <int Dim>
double stress_spread(const Simulation<Dim>& simulation, const Sym<double>& mean) {
  const Points<Dim>& points = simulation.state().bodies.front().points;
  double maximum = 0.0;
  for (Index p = 0; p < points.size(); ++p) {
    Sym<double> off;
    for (int c = 0; c < 6; ++c)
      off.m[static_cast<std::size_t>(c)] = points.stress[c][p] - mean.m[static_cast<std::size_t>(c)];
    maximum = std::max(maximum, norm(off));
  }
  return maximum / norm(mean);
}

template Simulation<2> make_element<2>(const ElementCase&, const Catalogue&, const Sym<double>&);
template Simulation<3> make_element<3>(const ElementCase&, const Catalogue&, const Sym<double>&);
template void follow_element<2>(MaterialPoint&, const Simulation<2>&);
template void follow_element<3>(MaterialPoint&, const Simulation<3>&);
template double stress_spread<2>(const Simulation<2>&, const Sym<double>&);
template double stress_spread<3>(const Simulation<3>&, const Sym<double>&);

} // namespace riedel
