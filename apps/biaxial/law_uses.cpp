#include "apps/biaxial/law_uses.hpp"

#include "core/base/error.hpp"
#include "core/case/case_text.hpp"
#include "core/case/material_keys.hpp"

#include <algorithm>

namespace riedel {

namespace {

const std::vector<std::string> of_void_ratio{"specimen.void_ratio",    "imperfection.void_ratio",
                                             "imperfection.deviation", "imperfection.correlation_length",
                                             "imperfection.seed",      "output.band_void_ratio"};

bool is_given(const CaseFile& given, const std::string& key) {
  const std::vector<std::string> names = given.names_in(key.substr(0, key.find('.')));
  return std::ranges::find(names, key) != names.end();
}

Key& named(Keys& keys, std::string_view name) { return *std::ranges::find(keys, name, &Key::name); }

bool is_on(const Values& values, const std::string& key) { return values.has(key) && values.flag(key); }

std::string reason(const Values& v, const std::string& model) {
  if (is_on(v, "material.intergranular_strain"))
    return "with intergranular strain the law uses no average"; // a small strain has no width to keep
  const std::string name = "\"" + model + "\" ";
  if (v.has("material.takes_average")) return name + "uses no average without material.takes_average = true";
  if (v.has("material.softening_strain")) return name + "uses no average while it does not soften";
  return name + "uses no average";
}

/// The laws of the catalogue that use the void ratio, with their own defaults.
std::string laws_with_void_ratio(const Catalogue& catalogue) {
  std::string names;
  for (const auto& law : catalogue.materials.entries()) {
    Values values;
    for (const Key& key : law.description.parameters) values.set("material." + key.name, key.default_value);
    values.set("material.model", law.description.name);
    if (const auto uses = law_uses(values, catalogue); uses && uses->void_ratio)
      names += (names.empty() ? "" : ", ") + law.description.name;
  }
  return names;
}

/// Refuses a factor that moves a parameter out of its bounds.
void check_weakened(const LawUses& uses, const Values& v, const Catalogue& catalogue, std::vector<Finding>& errors) {
  const double factor = v.number("imperfection.factor");
  try {
    (void)catalogue.materials.find(uses.model).make(weakened(v.section("material"), factor));
  } catch (const InputError& error) {
    errors.push_back({{"imperfection.factor"}, exact_text(factor) + " makes the law invalid: " + error.what()});
  }
}

void check_patch(const LawUses& uses, const Values& v, std::vector<Finding>& errors) {
  const auto& size = v.numbers("imperfection.size");
  const double factor = v.number("imperfection.factor");
  const std::string patch = toml_text(v.at("imperfection.size")), name = "\"" + uses.model + "\"";
  if (factor != 1.0 && !uses.strength)
    errors.push_back({{"imperfection.factor", "material.model"},
                      exact_text(factor) + " means nothing to " + name +
                          ", which has no parameters of strength (cohesion, friction_angle, phi_c); allowed: 1"});
  else if (!uses.void_ratio && factor == 1.0 && size[0] * size[1] > 0.0)
    errors.push_back({{"imperfection.size", "imperfection.factor", "material.model"},
                      patch + " means nothing to " + name + ", which has no void ratio" +
                          (uses.strength ? "; allowed: [0, 0], or a weak patch by imperfection.factor, such as 0.8"
                                         : " and no strength; allowed: [0, 0]")});
}

} // namespace

std::optional<LawUses> law_uses(const Values& values, const Catalogue& catalogue) {
  LawUses uses{.model = values.text("material.model"), .averaged = {}, .why_local = {}};
  try {
    const auto law = catalogue.materials.find(uses.model).make(values.section("material"));
    if (!is_on(values, "material.intergranular_strain")) uses.averaged = law->nonlocal_variables();
    uses.void_ratio = state_column(law->states(), "void_ratio") >= 0 || has_limits_of_void_ratio(values);
  } catch (const InputError&) { return std::nullopt; } catch (const PluginError&) {
    return std::nullopt;
  }
  if (uses.averaged.empty()) uses.why_local = reason(values, uses.model);
  uses.strength = has_strength(values.section("material"));
  return uses;
}

std::vector<std::string> fit_defaults(Keys& keys, const LawUses& uses, const CaseFile& given, const Values& values) {
  std::vector<std::string> notes;
  if (uses.averaged.empty()) {
    Key& length = named(keys, "nonlocal.length");
    length.default_value = 0.0;
    length.doc += "; here 0, since " + uses.why_local;
    if (!is_given(given, length.name)) notes.push_back(length.name + " = 0: " + uses.why_local + "; the run is local");
  } else {
    Key& variable = named(keys, "nonlocal.variable");
    variable.choices = uses.averaged;
    if (std::ranges::find(uses.averaged, std::get<std::string>(variable.default_value)) == uses.averaged.end())
      variable.default_value = uses.averaged.front();
  }
  if (!uses.void_ratio && (!uses.strength || values.number("imperfection.factor") == 1.0)) {
    Key& size = named(keys, "imperfection.size");
    size.default_value = std::vector<double>{0.0, 0.0};
    size.doc += "; here none, since \"" + uses.model + "\" has no void ratio";
    if (!is_given(given, size.name))
      notes.push_back(size.name + " = [0, 0]: \"" + uses.model + "\" has no void ratio, so there is no loose patch" +
                      (uses.strength ? "; imperfection.factor makes a weak one" : ""));
  }
  return notes;
}

void check_uses(const LawUses& uses, const CaseFile& given, const Values& values, const Catalogue& catalogue,
                std::vector<Finding>& errors) {
  if (const double length = values.number("nonlocal.length"); uses.averaged.empty() && length > 0.0)
    errors.push_back({{"nonlocal.length", "material.model", "material.intergranular_strain"},
                      exact_text(length) + " is out of range: " + uses.why_local + "; allowed: 0, or leave it out"});
  if (!uses.void_ratio)
    for (const std::string& key : of_void_ratio)
      if (is_given(given, key))
        errors.push_back({{key, "material.model"},
                          toml_text(values.at(key)) + " means nothing: \"" + uses.model +
                              "\" has no void ratio; leave it out, or take one of the laws that have it: " +
                              laws_with_void_ratio(catalogue)});
  check_patch(uses, values, errors);
  if (uses.strength && values.number("imperfection.factor") != 1.0) check_weakened(uses, values, catalogue, errors);
}

void leave_out_useless(Keys& keys, const LawUses& uses) {
  if (!uses.void_ratio)
    std::erase_if(keys,
                  [](const Key& key) { return std::ranges::find(of_void_ratio, key.name) != of_void_ratio.end(); });
}

} // namespace riedel
