/// The specimen between plates, run by the material point method, as a driver of element tests.
#include "apps/element/drivers.hpp"
#include "apps/element/path.hpp"
#include "apps/element/specimen.hpp"
#include "apps/element/tests/tests.hpp"
#include "core/base/error.hpp"
#include "core/io/messages.hpp"
#include "core/run/run.hpp"
#include "core/run/watches.hpp"
#include "materials/element/rows.hpp"

namespace riedel {

namespace {

/// The strain that the test drives, γ or ε1.
double driven_strain(const MaterialPoint& mean, const ElementTest& test) {
  return test.shears() ? mean.F(0, 1) : 1.0 - mean.F(0, 0);
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
  const ElementTest& test = element_test(v);
  const ElementPath path = element_path(v);
  const PathStage& stage = path.stages.front();
  Simulation<Dim> simulation = make_element<Dim>(v, catalogue, path.stress);
  refuse_endless(v, simulation.time_step());
  ThreadChoice threads(watch.threads);
  const Material& law = *simulation.state().bodies.front().material;
  ElementCurve curve{.test = test.name, .energies = ElementEnergies{}};
  ElementRows rows(law, v.number("specimen.void_ratio"), v.number("output.every_strain"), path.friction, path.water,
                   watch, curve.rows);
  MaterialPoint mean{.state = std::vector<double>(static_cast<std::size_t>(state_components(law.states())))};
  const auto follow = [&] {
    curve.steps = simulation.state().step;
    follow_element(mean, simulation);
    rows.look(mean);
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
      .until("strain", [&] { return driven_strain(mean, test) >= v.number("loading.final_strain"); });
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
  curve.energies->kinetic_over_internal = kinetic.greatest();
  curve.energies->time_step_over_limit = time_step.greatest();
  curve.report = simulation.state().report;
  return curve;
}

} // namespace

ElementCurve run_mpm_driver(const Values& values, const Catalogue& catalogue, const ElementWatch& watch) {
  return dimensions_of_element(values) == 3 ? run<3>(values, catalogue, watch) : run<2>(values, catalogue, watch);
}

} // namespace riedel
