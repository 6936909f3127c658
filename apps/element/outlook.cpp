#include "apps/element/outlook.hpp"

#include "apps/element/specimen.hpp"
#include "core/case/outlook_text.hpp"
#include "core/setup/ramp.hpp"
#include "materials/element/wave_speeds.hpp"

#include <cmath>

namespace riedel {

namespace {

/// Of a specimen.
struct Steps {
  std::vector<std::int64_t> cells;
  std::int64_t points = 1;
  double cell = 0.0; ///< [m]
  double step = 0.0; ///< [s]
  double count = 0.0;
};

Steps steps_of(const Values& v, const Catalogue& catalogue) {
  Steps all{.cells =
                std::vector<std::int64_t>(static_cast<std::size_t>(dimensions_of_element(v)), v.integer("grid.cells"))};
  for (const std::int64_t along : all.cells) all.points *= along * v.integer("specimen.points_per_cell");
  const double edge = v.number("specimen.size");
  all.cell = edge / v.number("grid.cells");
  const auto law = catalogue.materials.find(v.text("material.model")).make(v.section("material"));
  double pressure = 0.0; // at the start has a name of its own in each test
  for (const char* key : {"loading.confining_pressure", "loading.initial_pressure", "loading.normal_stress"})
    if (v.has(key)) pressure = v.number(key);
  const double speed = wave_speeds(*law, pressure, v.number("specimen.void_ratio")).at_start;
  all.step = v.is_text("time.step") ? v.number("time.cfl") * all.cell / speed : v.number("time.step");
  all.count =
      time_to(v.number("loading.final_strain") * edge, v.number("loading.speed"), v.number("loading.ramp_time")) /
      all.step;
  return all;
}

} // namespace

std::string element_outlook(const Values& v, const Catalogue& catalogue, ThreadRange threads) {
  const std::string head = outlook_head();
  if (v.text("driver.kind") == "point")
    return head + outlook_line("expected", "one point, without a grid, on one thread");
  const Steps s = steps_of(v, catalogue);
  return head +
         outlook_line("expected", std::to_string(s.points) + " points, " + std::to_string(std::llround(s.count)) +
                                      " steps of " + short_text(s.step) + " s") +
         outlook_line("cells", product_text(s.cells) + " of " + short_text(1e3 * s.cell) + " mm") +
         outlook_line("threads", threads_text(threads));
}

ExpectedRun expected_element(const Values& v, const Catalogue& catalogue) {
  constexpr double rows = 1000.0; // of a test at one point, each of some evaluations of the law
  const bool has_end = v.has("loading.final_strain");
  ExpectedRun run{.work = rows, .end = has_end ? v.number("loading.final_strain") : 0.0};
  if (v.text("driver.kind") == "mpm") {
    const Steps steps = steps_of(v, catalogue);
    run.work = static_cast<double>(steps.points) * steps.count;
  }
  return run;
}

} // namespace riedel
