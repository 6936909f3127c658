/// Simple shear of planes normal to 2 along 1, under a constant normal stress: the specimen may dilate.
#include "apps/element/tests/tests.hpp"

namespace riedel {

ElementTest shear_test() {
  return {.name = "shear",
          .title = "Simple shear with free dilatancy",
          .loading = {element_pressure_key("normal_stress", 200e3,
                                           "normal stress, constant, and pressure from all sides at the start"),
                      element_strain_key(0.5, "shear strain u/h0 at which the test ends", 100.0)},
          .pressure_key = "loading.normal_stress",
          .pressure_name = "normal stress",
          .normal = {"eps_1", "sigma_2", "eps_3"},
          .driven = "gamma",
          .friction = Friction::on_planes,
          .plates = {PlateMotion::driven, PlateMotion::free, PlateMotion::fixed},
          .pictures = {{"friction.png", picture_axes::gamma(), picture_axes::phi()},
                       {"void_ratio.png", picture_axes::gamma(), picture_axes::void_ratio()},
                       {"stress_strain.png", picture_axes::gamma(), picture_axes::tau()},
                       {"p_q.png", picture_axes::p(), picture_axes::tau()}}};
}

} // namespace riedel
