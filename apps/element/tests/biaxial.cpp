/// Compression along 1 in plane strain, under a pressure along 2.
#include "apps/element/tests/tests.hpp"

namespace riedel {

ElementTest biaxial_element_test() {
  return {.name = "biaxial",
          .title = "Plane strain compression",
          .void_ratio = 0.55,
          .loading = {element_pressure_key("confining_pressure", 50e3, "lateral pressure, constant"),
                      element_strain_key(0.06, ends_at_vertical_strain)},
          .pressure_key = "loading.confining_pressure",
          .pressure_name = "confining pressure",
          .normal = {"eps_1", "sigma_2", "eps_3"},
          .plates = {PlateMotion::driven, PlateMotion::free, PlateMotion::fixed},
          .pictures = pictures_of_compression()};
}

} // namespace riedel
