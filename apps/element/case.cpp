#include "apps/element/case.hpp"

#include "apps/element/tests/tests.hpp"

#include <numbers>

namespace riedel {

namespace {

ElementCase::Loading loading_of(const ElementTest& test, const Values& v) {
  return {.pressure = v.number(test.pressure_key),
          .final_strain = v.number("loading.final_strain"),
          .limit = test.limit_key.empty() ? std::nullopt : std::optional(v.number(test.limit_key)),
          .rate = v.number("loading.rate"),
          .speed = v.number("loading.speed"),
          .ramp_time = v.number("loading.ramp_time")};
}

ElementCase::Specimen specimen_of(const ElementTest& test, const Values& v) {
  const bool automatic = v.is_text("grid.dimensions");
  return {.size = v.number("specimen.size"),
          .cells = v.integer("grid.cells"),
          .points_per_cell = v.integer("specimen.points_per_cell"),
          .dimensions = automatic ? test.dimensions : static_cast<int>(v.number("grid.dimensions")),
          .free_interior = v.text("specimen.interior") == "free"};
}

ElementCase::Initial initial_of(const Values& v) {
  ElementCase::Initial initial{.pore_pressure = v.number("initial.pore_pressure"),
                               .water_bulk_modulus = v.number("specimen.water_bulk_modulus")};
  const std::vector<double>&sigma = v.numbers("initial.sigma"), &h = v.numbers("initial.intergranular_strain");
  const std::array shears{v.number("initial.tau"), v.number("initial.tau_13"), v.number("initial.tau_23")};
  for (std::size_t c = 0; c < 3; ++c) {
    initial.total_stress.m[c] = -sigma[c];
    initial.total_stress.m[3 + c] = std::numbers::sqrt2 * shears[c];
    initial.intergranular_strain[c] = h[c];
  }
  return initial;
}

} // namespace

ElementCase::ElementCase(const Values& v)
    : test(v.text("test")),
      named(find_element_test(test)),
      void_ratio(v.number("specimen.void_ratio")),
      material{.model = v.text("material.model"), .parameters = v.section("material")},
      driver{.kind = v.text("driver.kind"), .tolerance = v.number("driver.tolerance")},
      every_strain(v.number("output.every_strain")),
      plots(v.flag("output.plots")),
      keys(v) {
  if (named == nullptr) {
    initial = initial_of(v);
    return;
  }
  loading = loading_of(*named, v);
  specimen = specimen_of(*named, v);
  scheme = v.text("scheme");
  interpolation = v.section("interpolation");
}

} // namespace riedel
