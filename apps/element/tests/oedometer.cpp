/// Compression along 1 in a stiff ring.
#include "apps/element/tests/tests.hpp"

namespace riedel {

ElementTest oedometer_test() {
  return {.name = "oedometer",
          .title = "Oedometric compression",
          .loading = {element_pressure_key("initial_pressure", 1e3, "pressure from all sides at the start"),
                      element_strain_key(0.06, ends_at_vertical_strain),
                      element_pressure_key("final_stress", 3e6,
                                           "vertical stress at which the test ends, if it comes first")},
          .pressure_key = "loading.initial_pressure",
          .pressure_name = "initial pressure",
          .normal = {"eps_1", "eps_2", "eps_3"},
          .limit_measure = "sigma_1",
          .limit_key = "loading.final_stress",
          .confined = false,
          .pictures = {{"stress_strain.png", picture_axes::eps_1(), picture_axes::sigma_1()},
                       {"compression.png", picture_axes::sigma_1(), picture_axes::void_ratio(), true},
                       {"p_q.png", picture_axes::p(), picture_axes::q()}}};
}

} // namespace riedel
