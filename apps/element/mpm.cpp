/// The specimen between plates, run by the material point method, as a driver of element tests.
#include "apps/element/drivers.hpp"
#include "apps/element/path.hpp"
#include "apps/element/specimen.hpp"
#include "core/base/error.hpp"
#include "core/io/messages.hpp"
#include "core/run/run.hpp"
#include "core/run/watches.hpp"
#include "materials/element/rows.hpp"

namespace riedel {

namespace {

/// The prescribed strain of the test, γ or ε1.
double driven_strain(const MaterialPoint& mean, const ElementTest& test) {
  return test.shears() ? mean.F(0, 1) : 1.0 - mean.F(0, 0);
}

/// @throws InputError for a test of too many steps
void refuse_endless(const ElementCase& given, double time_step) {
  constexpr double max_steps = 1e9;
  const auto& [pressure, final_strain, limit, rate, speed, ramp_time] = given.loading;
  const double time = ramp_time + final_strain * given.specimen.size / speed;
  if (time / time_step > max_steps)
    throw InputError("loading.speed: " + exact_text(speed) + " m/s makes about " + short_text(time / time_step) +
                     " steps of " + short_text(time_step) + " s; allowed: at most " + short_text(max_steps));
}

template <int Dim>
ElementCurve run(const ElementCase& given, const Catalogue& catalogue, const ElementWatch& watch) {
  constexpr int steps_between_checks = 10; // the sums over the points cost as much as a step does
  const ElementTest& test = *given.named;
  const ElementPath path = element_path(given);
  const PathStage& stage = path.stages.front();
  Simulation<Dim> simulation = make_element<Dim>(given, catalogue, path.stress);
  refuse_endless(given, simulation.time_step());
  ThreadChoice threads(watch.threads);
  const Material& law = *simulation.state().bodies.front().material;
  ElementCurve curve{.test = test.name, .energies = ElementEnergies{}};
  ElementRows rows(law, given.void_ratio, given.every_strain, path.friction, path.water, watch, curve.rows);
  MaterialPoint mean{.state = std::vector<double>(static_cast<std::size_t>(state_components(law.states())))};
  const auto follow = [&] {
    curve.steps = simulation.state().step;
    follow_element(mean, simulation);
    rows.record(mean);
  };
  KineticShare kinetic;
  TimeStepWatch time_step;
  const auto check = [&] {
    kinetic.record(driven_strain(mean, test), simulation.energies());
    time_step.record(simulation);
    curve.energies->stress_spread = std::fmax(curve.energies->stress_spread, stress_spread(simulation, mean.stress));
  };
  bool interrupted = false;
  Run<Dim> loop(simulation, [&](const auto& step) { threads.step(step); });
  loop.after_steps(1, follow).after_steps(steps_between_checks, [&] {
    interrupted = watch.stop();
    check();
  });
  loop.until("interrupt", [&] { return interrupted; })
      .until("limit", [&] { return curve.steps > 0 && stage.until && stage.until->reached(mean, path.water); })
      .until("strain", [&] { return driven_strain(mean, test) >= given.loading.final_strain; });
  follow();
  try {
    const std::string end = loop.go();
    if (end == "interrupt") curve.interrupted = stage.name;
    if (end == "limit") curve.ends.push_back(stage.name + ": ended by " + stage.until->text());
    rows.write();
  } catch (const RunError& error) {
    rows.write();
    curve.failure = stage.name + ": " + error.what();
  }
  if (const std::string doubt = time_step.doubt(); !doubt.empty()) print_warning(doubt);
  const Energies end = simulation.energies();
  curve.energies->kinetic = end.kinetic;
  curve.energies->internal = end.internal;
  curve.energies->external = end.external;
  curve.energies->kinetic_over_internal = kinetic.maximum();
  curve.energies->time_step_over_limit = time_step.maximum();
  curve.report = simulation.state().report;
  return curve;
}

} // namespace

ElementCurve run_mpm_driver(const ElementCase& given, const Catalogue& catalogue, const ElementWatch& watch) {
  return given.specimen.dimensions == 3 ? run<3>(given, catalogue, watch) : run<2>(given, catalogue, watch);
}

} // namespace riedel
