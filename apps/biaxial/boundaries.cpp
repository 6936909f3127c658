#include "apps/biaxial/boundaries.hpp"

#include "core/setup/fill.hpp"
#include "core/step/boundaries/prescribed_velocity.hpp"
#include "core/step/boundaries/rigid_body.hpp"

namespace riedel {

namespace {

/// The outermost points at the two sides carry the lateral pressure.
template <int Dim>
SurfaceTraction<Dim> side_pressure(const SpecimenGeometry<Dim>& specimen, const Points<Dim>& points, double pressure) {
  SurfaceTraction<Dim> load{.value = uniform_pressure<Dim>(pressure), .initial_area = {}};
  load.initial_area.assign(static_cast<std::size_t>(points.size()), Vec<Dim>::Zero());
  for (Index p = 0; p < points.size(); ++p) {
    const double half = points.half_size[0][p], x = points.position[0][p];
    double face = 1.0; // [m or m²]
    for (int a = 1; a < Dim; ++a) face *= 2.0 * points.half_size[a][p];
    if (x < 1.5 * half) load.initial_area[static_cast<std::size_t>(p)][0] = -face;
    if (x > specimen.size[0] - 1.5 * half) load.initial_area[static_cast<std::size_t>(p)][0] = face;
  }
  return load;
}

/// Two layers of rigid points, from the specimen's row of cells `row` upwards. They extend beyond the sides as far as
/// the supports of their points allow, and beyond the depth by a cell.
template <int Dim>
RigidPoints<Dim> rigid_platen(const char* name, const SpecimenGeometry<Dim>& specimen, Index row,
                              const VelocityCourse& velocity) {
  RigidPoints<Dim> platen{.name = name, .direction = {.axis = 1}, .velocity = velocity};
  Counts<Dim> overhang{}, cells = specimen.cells;
  overhang[0] = std::max<Index>(specimen.margin_below[0] - 4, 0);
  if constexpr (Dim == 3) overhang[2] = 1;
  cells[1] = 2;
  Vec<Dim> corner;
  for (int a = 0; a < Dim; ++a) {
    cells[a] += 2 * overhang[a];
    corner[a] = (a == 1 ? row : -overhang[a]) * specimen.cell[a];
  }
  fill<Dim>(platen.points, lattice_of<Dim>(cells, specimen.cell, 1, corner), 0);
  return platen;
}

/// The bottom at rest with its middle fixed laterally, and the top, in the axes of the rotated specimen.
template <int Dim>
void set_turned_platens(Model<Dim>& model, const SpecimenGeometry<Dim>& s, const VelocityCourse& still,
                        const VelocityCourse& down) {
  if constexpr (Dim == 2) {
    RigidPoints<2> bottom = rigid_platen<2>("bottom", s, -2, still), top = rigid_platen<2>("top", s, s.cells[1], down);
    RigidPoints<2> pin{.name = "pin", .direction = {.axis = 0}, .velocity = still};
    const Vec<2> corner(0.5 * (s.size[0] - s.cell[0]), -0.5 * s.cell[1]);
    fill<2>(pin.points, lattice_of<2>({1, 1}, s.cell, 1, corner), 0);
    for (RigidPoints<2>* body : {&bottom, &pin, &top}) {
      turn_points<2>(body->points, s.turn);
      body->direction = {.axis = oblique, .unit = s.turn.rotation.col(body->direction.axis)};
      model.conditions.push_back(std::make_unique<RigidBody<2>>(std::move(*body)));
    }
  }
}

} // namespace

template <int Dim>
void set_platens(Model<Dim>& model, State<Dim>& state, const SpecimenGeometry<Dim>& s, const BiaxialCase& v) {
  const auto still = [](double) { return 0.0; };
  const auto down = ramped(-v.loading.speed, v.loading.ramp_time);
  if (!s.turn.is_none) return set_turned_platens<Dim>(model, s, still, down);
  Counts<Dim> end = state.grid.nodes;
  for (Index& n : end) --n;
  // Rows of nodes from side to side. Those beyond a platen or a wall move with it, so that a domain that extends over
  // the edge has no velocity gradient there.
  const auto rows = [&](const char* name, int axis, Index first, Index last, const auto& velocity) {
    VelocityOnNodes<Dim> nodes{.name = name, .last = end, .axis = axis, .velocity = velocity};
    nodes.first[axis] = first;
    nodes.last[axis] = last;
    return nodes;
  };
  const auto add = [&](const VelocityOnNodes<Dim>& nodes) { model.conditions.push_back(prescribe(nodes)); };
  const Index bottom = s.margin_below[1], top = bottom + s.cells[1];
  add(rows("bottom", 1, 0, bottom, still));
  VelocityOnNodes<Dim> pin = rows("pin", 1, bottom, bottom, still);
  pin.first[0] = pin.last[0] = s.margin_below[0] + s.cells[0] / 2;
  pin.axis = 0;
  add(pin);
  if constexpr (Dim == 3) {
    add(rows("back", 2, 0, s.margin_below[2], still));
    add(rows("front", 2, s.margin_below[2] + s.cells[2], end[2], still));
  }
  if (v.loading.platen == BiaxialCase::Platen::rigid_points) {
    model.conditions.push_back(std::make_unique<RigidBody<Dim>>(rigid_platen<Dim>("top", s, s.cells[1], down)));
  } else {
    add(rows("top", 1, top, end[1], down));
    model.moving_grids.push_back({.axis = 1, .fixed_row = bottom, .moving_row = top, .platen = "top"});
  }
}

template <int Dim>
void set_lateral_pressure(Model<Dim>& model, const Points<Dim>& points, const SpecimenGeometry<Dim>& specimen,
                          const BiaxialCase& v) {
  const double pressure = v.loading.confining_pressure;
  if (v.loading.lateral == BiaxialCase::Lateral::points)
    model.surface_tractions.push_back(side_pressure(specimen, points, pressure));
  else
    model.confining_pressure = pressure;
}

template void set_platens<2>(Model<2>&, State<2>&, const SpecimenGeometry<2>&, const BiaxialCase&);
template void set_platens<3>(Model<3>&, State<3>&, const SpecimenGeometry<3>&, const BiaxialCase&);
template void set_lateral_pressure<2>(Model<2>&, const Points<2>&, const SpecimenGeometry<2>&, const BiaxialCase&);
template void set_lateral_pressure<3>(Model<3>&, const Points<3>&, const SpecimenGeometry<3>&, const BiaxialCase&);

} // namespace riedel
