#include "apps/biaxial/idle_keys.hpp"
#include "apps/biaxial/keys.hpp"
#include "apps/biaxial/law_uses.hpp"
#include "apps/biaxial/sense.hpp"
#include "apps/built_in.hpp"
#include "apps/case_kind.hpp"
#include "core/case/material_keys.hpp"

namespace riedel {

CheckedCase biaxial_case(const CaseFile& given, const Catalogue& catalogue) {
  Keys keys = biaxial_keys(catalogue, model_of(given));
  const Values first = given.check(keys).values;
  const std::string& model = first.text("material.model");
  if (first.has("material.library") && !first.text("material.library").empty() && catalogue.materials.known(model))
    try_library(given, first, [&] { (void)catalogue.materials.find(model).make(first.section("material")); });
  const auto uses = law_uses(first, catalogue); // none for a law that is wrong, which is told below
  std::vector<std::string> notes;
  if (uses) notes = fit_defaults(keys, *uses, given, first);
  const auto check = [&](const Values& values) {
    Findings found = check_biaxial(values, catalogue);
    if (uses) check_uses(*uses, given, values, catalogue, found.errors);
    check_idle_keys(given, keys, values, found.warnings);
    check_sense(given, values, catalogue, found);
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
