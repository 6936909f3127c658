#include "apps/biaxial/case.hpp"

#include "apps/biaxial/idle_keys.hpp"
#include "apps/biaxial/keys.hpp"
#include "apps/biaxial/law_uses.hpp"
#include "apps/biaxial/sense.hpp"
#include "apps/built_in.hpp"
#include "apps/case_kind.hpp"
#include "core/case/material_keys.hpp"

namespace riedel {

namespace {

std::array<double, 2> two_numbers(const Values& v, const char* key) { return {v.numbers(key)[0], v.numbers(key)[1]}; }

std::array<std::int64_t, 2> two_integers(const Values& v, const char* key) {
  return {v.integers(key)[0], v.integers(key)[1]};
}

} // namespace

BiaxialCase::BiaxialCase(const Values& v)
    : scheme(v.text("scheme")),
      interpolation(v.section("interpolation")),
      specimen{.width = v.number("specimen.width"),
               .height = v.number("specimen.height"),
               .void_ratio = v.number("specimen.void_ratio"),
               .points_per_cell = v.integer("specimen.points_per_cell"),
               .rotation = v.number("specimen.rotation"),
               .depth_cells = v.integer("specimen.depth_cells")},
      imperfection{.void_ratio = v.number("imperfection.void_ratio"),
                   .size = two_numbers(v, "imperfection.size"),
                   .centre = two_numbers(v, "imperfection.centre"),
                   .factor = v.number("imperfection.factor"),
                   .deviation = v.number("imperfection.deviation"),
                   .correlation_length = v.number("imperfection.correlation_length"),
                   .seed = v.integer("imperfection.seed")},
      grid{.cells = two_integers(v, "grid.cells"), .dimensions = static_cast<int>(v.integer("grid.dimensions"))},
      loading{.speed = v.number("loading.speed"),
              .ramp_time = v.number("loading.ramp_time"),
              .final_strain = v.number("loading.final_strain"),
              .confining_pressure = v.number("loading.confining_pressure"),
              .gravity = v.number("loading.gravity"),
              .platen = v.text("loading.platen") == "rigid_points" ? Platen::rigid_points : Platen::moving_grid,
              .lateral = v.text("loading.lateral") == "points" ? Lateral::points : Lateral::virtual_stress},
      material{.model = v.text("material.model"), .parameters = v.section("material")},
      nonlocal{.length = v.number("nonlocal.length"),
               .variable = v.text("nonlocal.variable"),
               .search = v.text("nonlocal.search"),
               .averager = v.text("nonlocal.averager")},
      output{.every_strain = v.number("output.every_strain"),
             .frames_every_strain = v.number("output.frames_every_strain"),
             .vtk = v.flag("output.vtk"),
             .plots = v.flag("output.plots"),
             .band_void_ratio = v.number("output.band_void_ratio")},
      keys(v) {}

CheckedCase biaxial_case(const CaseFile& given, const Catalogue& catalogue) {
  Keys keys = biaxial_keys(catalogue, model_of(given));
  const Values first = given.check(keys).values;
  const std::string& model = first.text("material.model");
  if (first.has("material.library") && !first.text("material.library").empty() && catalogue.materials.known(model))
    try_library(given, first, [&] { (void)catalogue.materials.find(model).make(first.section("material")); });
  const auto uses = law_uses(first, catalogue); // none for an invalid law, which is reported below
  std::vector<std::string> notes;
  if (uses) notes = fit_defaults(keys, *uses, given, first);
  const auto check = [&](const Values& values) {
    Diagnostics found = check_biaxial(BiaxialCase(values), catalogue);
    if (uses) check_uses(*uses, given, values, catalogue, found.errors);
    check_idle_keys(given, keys, values, found.warnings);
    check_sense(given, BiaxialCase(values), catalogue, found);
    return found;
  };
  CheckedCase checked = checked_case(given, keys, check, [&](std::vector<Finding>& errors) {
    explain_unknown_biaxial_keys(given, catalogue, errors);
  });
  try_material(given, checked.values, catalogue);
  if (uses) leave_out_useless(checked.keys, *uses);
  checked.notes = std::move(notes);
  return checked;
}

} // namespace riedel
