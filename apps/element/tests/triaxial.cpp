/// Compression along 1 under the same pressure from all other sides.
#include "apps/element/tests/tests.hpp"

namespace riedel {

ElementTest triaxial_test() {
  return {.name = "triaxial",
          .title = "Triaxial compression",
          .loading = {element_pressure_key("confining_pressure", 500e3, "lateral pressure, constant"),
                      element_strain_key(0.3, ends_at_vertical_strain)},
          .pressure_key = "loading.confining_pressure",
          .pressure_name = "confining pressure",
          .normal = {"eps_1", "sigma_2", "sigma_3"},
          .dimensions = 3,
          .plates = {PlateMotion::driven, PlateMotion::free, PlateMotion::free},
          .pictures = pictures_of_compression()};
}

} // namespace riedel
