/// The specimen between plates, run by the material point method, as a driver of element tests.
#include "apps/element/drivers.hpp"
#include "apps/element/path.hpp"
#include "apps/element/specimen.hpp"
#include "core/base/error.hpp"
#include "materials/element/rows.hpp"

namespace riedel {

namespace {

/// The strain that the test prescribes: of the shear test, or of any other.
double prescribed_strain(const LawPoint& mean, const Values& v) {
  return v.text("test") == "shear" ? mean.F(0, 1) : 1.0 - mean.F(0, 0);
}

template <int Dim>
void watch_energies(ElementEnergies& energies, const Simulation<Dim>& simulation, double strain) {
  constexpr double settled = 0.005; // before it the internal energy is too small to compare with
  const Energies now = simulation.energies();
  energies.kinetic = now.kinetic;
  energies.internal = now.internal;
  energies.external = now.external;
  if (strain >= settled && now.internal != 0.0)
    energies.kinetic_over_internal = std::fmax(energies.kinetic_over_internal, now.kinetic / std::abs(now.internal));
}

/// @throws InputError where nobody could wait for the end
void refuse_endless(const Values& v, double time_step) {
  constexpr double most_steps = 1e9;
  const double time = v.number("loading.ramp_time") +
                      v.number("loading.final_strain") * v.number("specimen.size") / v.number("loading.speed");
  if (time / time_step > most_steps)
    throw InputError("loading.speed: " + exact_text(v.number("loading.speed")) + " m/s makes about " +
                     short_text(time / time_step) + " steps of " + short_text(time_step) + " s; allowed: at most " +
                     short_text(most_steps));
}

template <int Dim>
ElementCurve run(const Values& v, const Catalogue& catalogue, const ElementWatch& watch) {
  constexpr int steps_between_checks = 10; // the sums over the points cost as much as a step does
  const ElementPath path = element_path(v);
  const PathStage& stage = path.stages.front();
  Simulation<Dim> simulation = make_element<Dim>(v, catalogue, path.stress);
  refuse_endless(v, simulation.time_step());
  ThreadChoice threads(watch.threads);
  const Material& law = *simulation.state().bodies.front().material;
  ElementCurve curve{.test = v.text("test"), .energies = ElementEnergies{}};
  ElementRows rows(law, v.number("specimen.void_ratio"), v.number("output.every_strain"), path.friction, path.water,
                   watch, curve.rows);
  LawPoint mean{.state = std::vector<double>(static_cast<std::size_t>(state_components(law.states())))};
  follow_element(mean, simulation);
  rows.look(mean);
  try {
    while (curve.interrupted.empty() && curve.ends.empty() &&
           prescribed_strain(mean, v) < v.number("loading.final_strain")) {
      threads.step([&] { simulation.step(); });
      ++curve.steps;
      follow_element(mean, simulation);
      rows.look(mean);
      if (stage.until && stage.until->reached(mean, path.water))
        curve.ends.push_back(stage.name + ": ended by " + stage.until->text());
      if (curve.steps % steps_between_checks != 0) continue;
      if (watch.stop()) curve.interrupted = stage.name;
      curve.energies->stress_spread = std::fmax(curve.energies->stress_spread, stress_spread(simulation, mean.stress));
      watch_energies(*curve.energies, simulation, prescribed_strain(mean, v));
    }
    rows.write();
  } catch (const RunError& error) {
    rows.write();
    curve.failure = stage.name + ": " + error.what();
  }
  curve.report = simulation.state().report;
  return curve;
}

} // namespace

ElementCurve run_mpm_driver(const Values& values, const Catalogue& catalogue, const ElementWatch& watch) {
  return dimensions_of_element(values) == 3 ? run<3>(values, catalogue, watch) : run<2>(values, catalogue, watch);
}

} // namespace riedel
