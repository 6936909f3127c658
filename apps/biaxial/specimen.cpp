#include "apps/biaxial/specimen.hpp"

#include "apps/biaxial/boundaries.hpp"
#include "apps/biaxial/expected_work.hpp"
#include "apps/biaxial/patch.hpp"
#include "core/case/material_keys.hpp"
#include "core/case/step_keys.hpp"
#include "core/setup/fill.hpp"
#include "core/setup/random_field.hpp"
#include "core/setup/weak_zone.hpp"

#include <numbers>

namespace riedel {

namespace {

/// The case's law; with another strength in the patch if the case says so.
std::unique_ptr<Material> make_law(const BiaxialCase& v, const Catalogue& catalogue) {
  const auto& law = catalogue.materials.find(v.material.model);
  const Values material = v.material.parameters;
  const double factor = v.imperfection.factor;
  if (factor == 1.0 || SpecimenPatch(v).is_empty()) return law.make(material);
  return std::make_unique<WeakZoneLaw>(law.make(material), law.make(weakened(material, factor)));
}

/// Void ratio, strength, mass, and stresses in equilibrium with the pressure and the specimen's own weight.
template <int Dim>
void set_initial_state(Body<Dim>& body, const BiaxialCase& v) {
  const SpecimenPatch patch(v);
  const VoidRatioField field = random_field(v);
  const int e = state_column(body.material->states(), "void_ratio");
  const double e_0 = v.specimen.void_ratio, pressure = v.loading.confining_pressure;
  Points<Dim>& points = body.points;
  std::vector<double> state = body.material->initial_state();
  const auto density_at = [&](double void_ratio) {
    if (e >= 0) state[static_cast<std::size_t>(e)] = void_ratio;
    return body.material->density(state);
  };
  const double weight = density_at(e_0) * v.loading.gravity;
  const int zone = state_column(body.material->states(), WeakZoneLaw::zone);
  for (Index p = 0; p < points.size(); ++p) {
    const Vec<Dim> x = points.position_of(p);
    const bool in_patch = patch.contains(x);
    const double void_ratio = in_patch ? patch.void_ratio : e_0 + field(x.template head<2>());
    if (zone >= 0) state[static_cast<std::size_t>(zone)] = in_patch ? 1.0 : 0.0;
    points.mass[0][p] = density_at(void_ratio) * points.volume[0][p];
    for (std::size_t s = 0; s < state.size(); ++s) points.state[static_cast<int>(s)][p] = state[s];
    points.stress[0][p] = points.stress[2][p] = -pressure;
    points.stress[1][p] = -(pressure + weight * (v.specimen.height - points.position[1][p]));
  }
}

template <int Dim>
void set_averager(Body<Dim>& body, const BiaxialCase& v, const Catalogue& catalogue) {
  const double length = v.nonlocal.length;
  const std::string& variable = v.nonlocal.variable;
  const std::vector<std::string> offered = body.material->nonlocal_variables();
  if (length == 0.0 || offered.empty()) return;
  if (std::find(offered.begin(), offered.end(), variable) == offered.end())
    throw InputError("nonlocal.variable = \"" + variable + "\": the law cannot use its average");
  body.averaged_state = state_column(body.material->states(), variable);
  body.averager = catalogue.in<Dim>()
                      .averagers.find(v.nonlocal.averager)
                      .make(length, catalogue.in<Dim>().searches.find(v.nonlocal.search).make());
}

} // namespace

template <int Dim>
void set_biaxial_step(Model<Dim>& model, const BiaxialCase& v, const Catalogue& catalogue, const Material& law) {
  const double crossing_rate = wave_speeds(v, law).at_start / v.specimen.width, // [1/s]
      loading_rate = v.loading.speed / v.specimen.height;
  constexpr double slow_loading = 7e-5; // strain in the time that a wave takes: 0.05 m/s in the default case
  StepDefaults defaults;
  defaults.damping *= std::max(1.0, slow_loading * crossing_rate / loading_rate);
  set_step(model, v.keys, catalogue, crossing_rate, defaults);
}

template <int Dim>
Simulation<Dim> make_biaxial(const BiaxialCase& v, const Catalogue& catalogue) {
  Model<Dim> model;
  model.scheme = catalogue.in<Dim>().schemes.find(v.scheme).make(v.interpolation);
  std::unique_ptr<Material> law = make_law(v, catalogue);
  set_biaxial_step(model, v, catalogue, *law);
  model.stress_filter.volume_axes = 2; // plane strain, also in a slab

  const SpecimenGeometry<Dim> specimen(v, *model.scheme);
  model.gravity.template head<2>() = -v.loading.gravity * specimen.turn.rotation.col(1);
  State<Dim> state;
  state.grid = specimen.grid();
  Body<Dim>& body = state.bodies.emplace_back();
  body.name = "specimen";
  body.material = std::move(law);
  fill<Dim>(body.points, lattice_of<Dim>(specimen.cells, specimen.cell, static_cast<Index>(v.specimen.points_per_cell)),
            state_components(body.material->states()));
  set_initial_state(body, v);
  if (!specimen.turn.is_none) turn_points(body.points, specimen.turn);
  set_averager(body, v, catalogue);

  set_lateral_pressure(model, body.points, specimen, v);
  set_platens(model, state, specimen, v);
  return {std::move(model), std::move(state)};
}

template <int Dim>
double platen_force(const Simulation<Dim>& simulation, const BiaxialCase& values) {
  // The virtual stress leaves the reaction in excess of the confining pressure.
  return simulation.model().confining_pressure * values.specimen.width -
         simulation.boundary_report("top").reaction / specimen_depth(values);
}

template <int Dim>
double platen_impulse(const Simulation<Dim>& simulation, const BiaxialCase& values) {
  return platen_force(simulation, values) * simulation.time_step();
}

double mobilised_angle(double force, const BiaxialCase& values) {
  const double sigma_1 = force / values.specimen.width, sigma_3 = values.loading.confining_pressure;
  return std::asin((sigma_1 - sigma_3) / (sigma_1 + sigma_3)) * 180.0 / std::numbers::pi;
}

double true_angle(double force, double width, const BiaxialCase& values) {
  const double sigma_3 = values.loading.confining_pressure, excess = (force - sigma_3 * values.specimen.width) / width;
  return std::asin(excess / (excess + 2.0 * sigma_3)) * 180.0 / std::numbers::pi;
}

template <int Dim>
double present_width(const Points<Dim>& points, const BiaxialCase& values) {
  const auto [in_row, in_layer] = PointRows(values);
  const Vec<2> across = Turn(values).rotation.col(0);
  const auto place = [&](std::size_t id) {
    return across.dot(points.position_of(points.place[id]).template head<2>());
  };
  double sum = 0.0, rows = 0.0;
  for (std::size_t layer = 0; layer < points.place.size(); layer += in_layer)
    for (const std::size_t first : {layer, layer + in_layer - in_row}) {
      sum += place(first + in_row - 1) - place(first);
      rows += 1.0;
    }
  const double n = static_cast<double>(in_row);
  return n > 1.0 ? sum / rows * n / (n - 1.0) : values.specimen.width; // half a spacing on both sides
}

template double present_width<2>(const Points<2>&, const BiaxialCase&);
template double present_width<3>(const Points<3>&, const BiaxialCase&);
template void set_biaxial_step<2>(Model<2>&, const BiaxialCase&, const Catalogue&, const Material&);
template void set_biaxial_step<3>(Model<3>&, const BiaxialCase&, const Catalogue&, const Material&);
template Simulation<2> make_biaxial<2>(const BiaxialCase&, const Catalogue&);
template Simulation<3> make_biaxial<3>(const BiaxialCase&, const Catalogue&);
template double platen_force<2>(const Simulation<2>&, const BiaxialCase&);
template double platen_force<3>(const Simulation<3>&, const BiaxialCase&);
template double platen_impulse<2>(const Simulation<2>&, const BiaxialCase&);
template double platen_impulse<3>(const Simulation<3>&, const BiaxialCase&);

} // namespace riedel
