/// The point driver as a driver of element tests.
#include "apps/element_drivers.hpp"
#include "apps/element_path.hpp"
#include "apps/element_rows.hpp"

namespace riedel {

namespace {

LawPoint start_of(const Material& law, const Sym<double>& stress, const Values& values) {
  LawPoint start{.stress = stress, .state = law.initial_state()};
  const int e = state_column(law.states(), "void_ratio");
  if (e >= 0) start.state[static_cast<std::size_t>(e)] = values.number("specimen.void_ratio");
  const int h = state_column(law.states(), "intergranular_strain");
  if (h >= 0 && values.has("initial.intergranular_strain"))
    for (std::size_t c = 0; c < 3; ++c)
      start.state[static_cast<std::size_t>(h) + c] = 0.0 - values.numbers("initial.intergranular_strain")[c];
  if (survey(law, start).out_of_bounds > 0)
    throw InputError("the law does not admit the state at the start: void ratio " +
                     exact_text(values.number("specimen.void_ratio")) + ", mean pressure " +
                     exact_text(-trace(stress) / 3.0) + " Pa");
  return start;
}

/// @return whether the test goes on
bool follow_stage(PointDriver& driver, const PathStage& stage, const ElementWatch& watch, ElementRows& rows,
                  bool& interrupted) {
  for (std::int64_t round = 0; round < stage.repeat; ++round)
    for (const PathLeg& leg : stage.legs) {
      bool ended = false;
      driver.follow(leg_from(leg, driver.point()), [&](const LawPoint& point) {
        rows.look(point);
        interrupted = watch.stop();
        ended = stage.until && stage.until->reached(point);
        return !interrupted && !ended;
      });
      rows.write();
      if (interrupted) return false;
      if (ended) return true;
    }
  return true;
}

} // namespace

ElementCurve run_point_driver(const Values& values, const Catalogue& catalogue, const ElementWatch& watch) {
  const ElementPath path = element_path(values);
  const auto law = catalogue.materials.find(values.text("material.model")).make(values.section("material"));
  const LawPoint start = start_of(*law, path.stress, values);
  ElementCurve curve{.test = values.text("test")};
  const double every = values.number("output.every_strain");
  PointDriver driver(*law, start, {.tolerance = values.number("driver.tolerance"), .largest_strain = every});
  ElementRows rows(*law, values.number("specimen.void_ratio"), every, path.friction, watch, curve.rows);
  rows.look(start);
  for (const PathStage& stage : path.stages) {
    if (&stage != &path.stages.front()) driver.begin_stage();
    try {
      if (!follow_stage(driver, stage, watch, rows, curve.interrupted)) break;
    } catch (const RunError& error) {
      rows.write();
      curve.failure = stage.name + ": " + error.what();
      break;
    }
  }
  curve.steps = driver.steps();
  curve.report = driver.report();
  return curve;
}

} // namespace riedel
