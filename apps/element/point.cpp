/// The point driver as a driver of element tests.
#include "apps/element/drivers.hpp"
#include "apps/element/path.hpp"
#include "materials/element/follow_path.hpp"

namespace riedel {

namespace {

MaterialPoint start_of(const Material& law, const Sym<double>& stress, const ElementCase& given) {
  MaterialPoint start{.stress = stress, .state = law.initial_state()};
  const int e = state_column(law.states(), "void_ratio");
  if (e >= 0) start.state[static_cast<std::size_t>(e)] = given.void_ratio;
  const int h = state_column(law.states(), "intergranular_strain");
  if (h >= 0)
    for (std::size_t c = 0; c < 3; ++c)
      if (const double x = given.initial.intergranular_strain[c]; x != 0.0)
        start.state[static_cast<std::size_t>(h) + c] = -x;
  if (assess(law, start).out_of_bounds > 0)
    throw InputError("the law does not admit the state at the start: void ratio " + exact_text(given.void_ratio) +
                     ", mean pressure " + exact_text(-trace(stress) / 3.0) + " Pa");
  return start;
}

} // namespace

ElementCurve run_point_driver(const ElementCase& given, const Catalogue& catalogue, const ElementWatch& watch) {
  const ElementPath path = element_path(given);
  const auto law = catalogue.materials.find(given.material.model).make(given.material.parameters);
  const MaterialPoint start = start_of(*law, path.stress, given);
  const PathControl control{
      .tolerance = given.driver.tolerance, .every_strain = given.every_strain, .void_ratio = given.void_ratio};
  ElementCurve curve = follow_path(*law, start, path, control, watch);
  curve.test = given.test;
  return curve;
}

} // namespace riedel
