#include "apps/element/outlook.hpp"

#include "apps/element/case.hpp"
#include "core/case/outlook_text.hpp"
#include "core/setup/ramp.hpp"
#include "materials/element/wave_speeds.hpp"

#include <cmath>

namespace riedel {

namespace {

/// The cost of a specimen.
struct Steps {
  std::vector<std::int64_t> cells;
  std::int64_t points = 1;
  double cell = 0.0; ///< [m]
  double step = 0.0; ///< [s]
  double count = 0.0;
};

Steps steps_of(const ElementCase& given, const Catalogue& catalogue) {
  const auto& [edge, cells, points_per_cell, dimensions, free_interior] = given.specimen;
  Steps all{.cells = std::vector<std::int64_t>(static_cast<std::size_t>(dimensions), cells)};
  for (const std::int64_t along : all.cells) all.points *= along * points_per_cell;
  all.cell = edge / static_cast<double>(cells);
  const auto law = catalogue.materials.find(given.material.model).make(given.material.parameters);
  const double speed = wave_speeds(*law, given.loading.pressure, given.void_ratio).at_start;
  const Values& v = given.keys;
  all.step = v.is_text("time.step") ? v.number("time.cfl") * all.cell / speed : v.number("time.step");
  all.count = time_to(given.loading.final_strain * edge, given.loading.speed, given.loading.ramp_time) / all.step;
  return all;
}

} // namespace

std::string element_outlook(const Values& values, const Catalogue& catalogue, ThreadRange threads) {
  const ElementCase given(values);
  const std::string head = outlook_head();
  if (given.driver.kind == "point") return head + outlook_line("expected", "one point, without a grid, on one thread");
  const Steps s = steps_of(given, catalogue);
  return head +
         outlook_line("expected", std::to_string(s.points) + " points, " + std::to_string(std::llround(s.count)) +
                                      " steps of " + short_text(s.step) + " s") +
         outlook_line("cells", product_text(s.cells) + " of " + short_text(1e3 * s.cell) + " mm") +
         outlook_line("threads", threads_text(threads));
}

ExpectedRun expected_element(const Values& values, const Catalogue& catalogue) {
  const ElementCase given(values);
  constexpr double rows = 1000.0; // of a test at one point, each of some evaluations of the law
  ExpectedRun run{.work = rows, .end = given.loading.final_strain};
  if (given.driver.kind == "mpm") {
    const Steps steps = steps_of(given, catalogue);
    run.work = static_cast<double>(steps.points) * steps.count;
  }
  return run;
}

} // namespace riedel
