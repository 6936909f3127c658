#include "apps/specimen.hpp"

#include "apps/step_keys.hpp"

#include <numbers>

namespace riedel {

namespace {

/// The case's numbers, and what follows from them.
struct Specimen {
  Vec<2> size; ///< b0, h0 [m]
  Counts<2> cells;
  Vec<2> cell;                                ///< h [m]
  Index margin_x, margin_below, margin_above; ///< cells of the grid around the specimen
  bool rigid_platen, pressure_on_points;
  double pressure;

  Specimen(const Values& v, const ShapeFunction<2>& scheme)
      : size(v.number("specimen.width"), v.number("specimen.height")),
        rigid_platen(v.text("loading.platen") == "rigid_points"),
        pressure_on_points(v.text("loading.lateral") == "points"),
        pressure(v.number("loading.confining_pressure")) {
    for (std::size_t a = 0; a < 2; ++a) {
      cells[a] = static_cast<Index>(v.integers("grid.cells")[a]);
      cell[a] = size[a] / cells[a];
    }
    // A block above a band slides sideways by about 0.7 u; the specimen may also bulge.
    const double sideways = 0.75 * v.number("loading.final_strain") * size[1] + 0.15 * size[0];
    margin_below = scheme.margin() + 1;
    margin_above = margin_below + (rigid_platen ? 3 : 0);
    margin_x = scheme.margin() + 1 + static_cast<Index>(std::ceil(sideways / cell[0]));
  }

  [[nodiscard]] Grid<2> grid() const {
    Grid<2> grid;
    grid.cell = cell;
    grid.origin = {-margin_x * cell[0], -margin_below * cell[1]};
    grid.nodes = {cells[0] + 2 * margin_x + 1, cells[1] + margin_below + margin_above + 1};
    return grid;
  }
};

struct Imperfection {
  Vec<2> centre, size;
  double void_ratio;

  Imperfection(const Values& v, const Vec<2>& specimen)
      : centre(v.numbers("imperfection.centre")[0] * specimen[0], v.numbers("imperfection.centre")[1] * specimen[1]),
        size(v.numbers("imperfection.size")[0], v.numbers("imperfection.size")[1]),
        void_ratio(v.number("imperfection.void_ratio")) {}

  /// Half open, so that a patch of whole cells takes that many rows of points wherever its edges fall.
  [[nodiscard]] bool contains(const Vec<2>& x) const {
    const double round_off = 1e-9;
    for (int a = 0; a < 2; ++a) {
      const double from = centre[a] - 0.5 * size[a] - round_off;
      if (x[a] < from || x[a] >= from + size[a]) return false;
    }
    return true;
  }
};

/// Fills a rectangle from (0, bottom) with points, `per_cell` along each direction of a cell.
void fill_rectangle(Points<2>& points, const Counts<2>& cells, const Vec<2>& cell, Index per_cell, double bottom,
                    int states) {
  const Counts<2> count{cells[0] * per_cell, cells[1] * per_cell};
  const Vec<2> spacing = cell / per_cell;
  points.resize(count[0] * count[1], states);
  for (Index p = 0; p < points.size(); ++p) {
    points.position[0][p] = (p % count[0] + 0.5) * spacing[0];
    points.position[1][p] = bottom + (p / count[0] + 0.5) * spacing[1];
    for (int a = 0; a < 2; ++a) points.half_size[a][p] = 0.5 * spacing[a];
    points.volume[0][p] = points.initial_volume[0][p] = spacing[0] * spacing[1];
  }
}

/// Void ratio, mass, and stresses in equilibrium with the pressure and the specimen's own weight.
void set_initial_state(Body<2>& body, const Specimen& specimen, const Values& v) {
  const Imperfection patch(v, specimen.size);
  const int e = state_column(body.material->states(), "void_ratio");
  const double e_0 = v.number("specimen.void_ratio");
  Points<2>& points = body.points;
  std::vector<double> state(static_cast<std::size_t>(points.state.components()), 0.0);
  const auto density_at = [&](double void_ratio) {
    if (e >= 0) state[static_cast<std::size_t>(e)] = void_ratio;
    return body.material->density(state);
  };
  const double weight = density_at(e_0) * v.number("loading.gravity");
  for (Index p = 0; p < points.size(); ++p) {
    const double void_ratio = patch.contains(points.position_of(p)) ? patch.void_ratio : e_0;
    points.mass[0][p] = density_at(void_ratio) * points.volume[0][p];
    if (e >= 0) points.state[e][p] = void_ratio;
    points.stress[0][p] = points.stress[2][p] = -specimen.pressure;
    points.stress[1][p] = -(specimen.pressure + weight * (specimen.size[1] - points.position[1][p]));
  }
}

void set_averager(Body<2>& body, const Values& v, const Catalogue& catalogue) {
  const double length = v.number("nonlocal.length");
  const std::string& variable = v.text("nonlocal.variable");
  const std::vector<std::string> offered = body.material->nonlocal_variables();
  if (length == 0.0 || offered.empty()) return;
  if (std::find(offered.begin(), offered.end(), variable) == offered.end())
    throw InputError("nonlocal.variable = \"" + variable + "\": the law does not take it averaged");
  body.averaged_state = state_column(body.material->states(), variable);
  body.averager = catalogue.in_2d.averagers.find(v.text("nonlocal.averager"))
                      .make(length, catalogue.in_2d.searches.find(v.text("nonlocal.search")).make());
}

/// The columns of points at the two sides carry the lateral pressure.
SurfaceTraction<2> side_pressure(const Specimen& specimen, const Points<2>& points) {
  SurfaceTraction<2> load{.value = uniform_pressure<2>(specimen.pressure), .initial_area = {}};
  load.initial_area.assign(static_cast<std::size_t>(points.size()), Vec<2>::Zero());
  for (Index p = 0; p < points.size(); ++p) {
    const double half = points.half_size[0][p], edge = 2.0 * points.half_size[1][p], x = points.position[0][p];
    if (x < 1.5 * half) load.initial_area[static_cast<std::size_t>(p)] = {-edge, 0.0};
    if (x > specimen.size[0] - 1.5 * half) load.initial_area[static_cast<std::size_t>(p)] = {edge, 0.0};
  }
  return load;
}

RigidBody<2> rigid_platen(const Specimen& specimen, const std::function<double(double)>& velocity) {
  RigidBody<2> platen{.name = "top", .axis = 1, .velocity = velocity};
  const Index overhang = specimen.margin_x - 4;
  fill_rectangle(platen.points, {specimen.cells[0] + 2 * overhang, 2}, specimen.cell, 1, specimen.size[1], 0);
  for (Index p = 0; p < platen.points.size(); ++p) platen.points.position[0][p] -= overhang * specimen.cell[0];
  return platen;
}

void set_boundaries(Model<2>& model, State<2>& state, const Specimen& s, const Values& v) {
  const auto still = [](double) { return 0.0; };
  const auto down = ramped(-v.number("loading.speed"), v.number("loading.ramp_time"));
  const Index bottom = s.margin_below, top = s.margin_below + s.cells[1];
  const Counts<2> last{state.grid.nodes[0] - 1, state.grid.nodes[1] - 1};
  const Index middle = s.margin_x + s.cells[0] / 2;
  // Rows beyond a platen move with it, so that a domain reaching past the edge sees no gradient there.
  model.conditions.push_back({"bottom", {0, 0}, {last[0], bottom}, 1, still});
  model.conditions.push_back({"pin", {middle, bottom}, {middle, bottom}, 0, still});
  if (s.rigid_platen) {
    state.rigid_bodies.push_back(rigid_platen(s, down));
  } else {
    model.conditions.push_back({"top", {0, top}, last, 1, down});
    model.moving_grids.push_back({.axis = 1, .fixed_row = bottom, .moving_row = top, .platen = "top"});
  }
}

} // namespace

Simulation<2> make_biaxial(const Values& v, const Catalogue& catalogue) {
  Model<2> model;
  model.scheme = catalogue.in_2d.schemes.find(v.text("scheme")).make(v.section("interpolation"));
  set_step(model, v);
  model.gravity = {0.0, -v.number("loading.gravity")};

  const Specimen specimen(v, *model.scheme);
  const std::string& law = v.text("material.model");
  State<2> state;
  state.grid = specimen.grid();
  Body<2>& body = state.bodies.emplace_back();
  body.name = "specimen";
  body.material = catalogue.materials.find(law).make(v.section("material"));
  fill_rectangle(body.points, specimen.cells, specimen.cell, static_cast<Index>(v.integer("specimen.points_per_cell")),
                 0.0, state_components(body.material->states()));
  set_initial_state(body, specimen, v);
  set_averager(body, v, catalogue);

  if (specimen.pressure_on_points)
    model.surface_tractions.push_back(side_pressure(specimen, body.points));
  else
    model.confining_pressure = specimen.pressure;
  set_boundaries(model, state, specimen, v);
  return {std::move(model), std::move(state)};
}

double platen_force(const Simulation<2>& simulation, const Values& values) {
  // The virtual stress leaves the reaction in excess of the confining pressure.
  return simulation.model().confining_pressure * values.number("specimen.width") - simulation.held("top").reaction;
}

double mobilised_angle(double force, const Values& values) {
  const double sigma_1 = force / values.number("specimen.width"), sigma_3 = values.number("loading.confining_pressure");
  return std::asin((sigma_1 - sigma_3) / (sigma_1 + sigma_3)) * 180.0 / std::numbers::pi;
}

} // namespace riedel
