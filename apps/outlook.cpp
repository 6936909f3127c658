#include "apps/outlook.hpp"

#include "apps/biaxial_sense.hpp"
#include "apps/element_specimen.hpp"
#include "apps/memory_needed.hpp"
#include "apps/memory_there.hpp"
#include "apps/specimen.hpp"
#include "apps/step_keys.hpp"

#include <cmath>

namespace riedel {

namespace {

std::string line(const std::string& name, const std::string& text) { return "# " + name + ": " + text + "\n"; }

std::string threads_text(ThreadRange threads) {
  const std::string most = std::to_string(threads.most);
  return threads.least == threads.most ? most
                                       : std::to_string(threads.least) + " to " + most + ", chosen while it runs";
}

std::string product(const std::vector<std::int64_t>& counts) {
  std::int64_t all = 1;
  std::string factors;
  for (const std::int64_t count : counts) {
    all *= count;
    factors += (factors.empty() ? "" : " x ") + std::to_string(count);
  }
  return std::to_string(all) + " (" + factors + ")";
}

/// What the rates are that a case leaves to the speed of waves.
std::string rates_text(const Values& v, const Catalogue& catalogue) {
  const auto law = catalogue.materials.find(v.text("material.model")).make(v.section("material"));
  Model<2> model;
  model.scheme = catalogue.in_2d.schemes.find(v.text("scheme")).make(v.section("interpolation"));
  set_biaxial_step(model, v, *law);
  const std::string damping = model.transfer != VelocityTransfer::flip ? "none by FLIP and PIC"
                              : model.damping ? "damping " + short_text(*model.damping) + " 1/s"
                                              : "FLIP " + short_text(model.flip) + " by step";
  const StressFilter& filter = model.stress_filter;
  return damping + (filter.on() ? ", stresses filtered at " + short_text(filter.stress_rate) + " 1/s, volumes at " +
                                      short_text(filter.volume_rate) + " 1/s"
                                : ", stresses not filtered");
}

} // namespace

std::string biaxial_outlook(const Values& v, const Catalogue& catalogue, ThreadRange threads) {
  std::vector<std::int64_t> cells = v.integers("grid.cells");
  const double width = v.number("specimen.width") / static_cast<double>(cells[0]),
               height = v.number("specimen.height") / static_cast<double>(cells[1]);
  if (dimensions_of_biaxial(v) == 3) cells.push_back(v.integer("specimen.depth_cells"));
  return "\n# What will run\n" + line("expected", expected_text(expected_work_of(v, catalogue))) +
         line("cells",
              product(cells) + " of " + short_text(1e3 * width) + " mm x " + short_text(1e3 * height) + " mm") +
         line("rates", rates_text(v, catalogue)) +
         line("memory", "about " + bytes_text(memory_needed(v, catalogue).all())) +
         line("threads", threads_text(threads));
}

std::string element_outlook(const Values& v, const Catalogue& catalogue, ThreadRange threads) {
  const std::string head = "\n# What will run\n";
  if (v.text("driver.kind") == "point") return head + line("expected", "one point, without a grid, on one thread");
  const auto dimensions = static_cast<std::size_t>(dimensions_of_element(v));
  const std::vector<std::int64_t> cells(dimensions, v.integer("grid.cells"));
  std::int64_t points = 1;
  for (const std::int64_t along : cells) points *= along * v.integer("specimen.points_per_cell");
  const double edge = v.number("specimen.size"), cell = edge / v.number("grid.cells");
  const auto law = catalogue.materials.find(v.text("material.model")).make(v.section("material"));
  Values start = v; // the pressure at the start has a name of its own in each test
  for (const char* pressure : {"loading.initial_pressure", "loading.normal_stress"})
    if (v.has(pressure)) start.set("loading.confining_pressure", v.at(pressure));
  const double step =
      v.is_text("time.step") ? v.number("time.cfl") * cell / wave_speeds(start, *law).at_start : v.number("time.step");
  const double time =
      time_to(v.number("loading.final_strain") * edge, v.number("loading.speed"), v.number("loading.ramp_time"));
  return head +
         line("expected", std::to_string(points) + " points, " + std::to_string(std::llround(time / step)) +
                              " steps of " + short_text(step) + " s") +
         line("cells", product(cells) + " of " + short_text(1e3 * cell) + " mm") +
         line("threads", threads_text(threads));
}

} // namespace riedel
