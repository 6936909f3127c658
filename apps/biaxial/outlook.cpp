#include "apps/biaxial/outlook.hpp"

#include "apps/biaxial/memory_needed.hpp"
#include "apps/biaxial/sense.hpp"
#include "apps/biaxial/specimen.hpp"
#include "core/case/outlook_text.hpp"
#include "core/run/memory_there.hpp"

namespace riedel {

namespace {

/// The rates that are derived from the wave speed.
std::string rates_text(const BiaxialCase& v, const Catalogue& catalogue) {
  const auto law = catalogue.materials.find(v.material.model).make(v.material.parameters);
  Model<2> model;
  model.scheme = catalogue.in_2d.schemes.find(v.scheme).make(v.interpolation);
  set_biaxial_step(model, v, catalogue, *law);
  const StressFilter& filter = model.stress_filter;
  return model.transfer->damping_text() + (filter.on()
                                               ? ", stresses filtered at " + short_text(filter.stress_rate) +
                                                     " 1/s, volumes at " + short_text(filter.volume_rate) + " 1/s"
                                               : ", stresses not filtered");
}

} // namespace

std::string biaxial_outlook(const BiaxialCase& v, const Catalogue& catalogue, ThreadRange threads) {
  std::vector<std::int64_t> cells(v.grid.cells.begin(), v.grid.cells.end());
  const double width = v.specimen.width / static_cast<double>(cells[0]),
               height = v.specimen.height / static_cast<double>(cells[1]);
  if (v.grid.dimensions == 3) cells.push_back(v.specimen.depth_cells);
  return outlook_head() + outlook_line("expected", expected_text(expected_work_of(v, catalogue))) +
         outlook_line("cells", product_text(cells) + " of " + short_text(1e3 * width) + " mm x " +
                                   short_text(1e3 * height) + " mm") +
         outlook_line("rates", rates_text(v, catalogue)) +
         outlook_line("memory", "about " + bytes_text(memory_needed(v, catalogue).all())) +
         outlook_line("threads", threads_text(threads));
}

} // namespace riedel
